#!/usr/bin/env bash
# Stores the templates of commands.txt anew, as the built program makes them now. Run it only when
# a change of the pictures is meant, look at what changed, and say why in the commit.
#   tests/regression/update_templates.sh [BUILD_FOLDER]
set -euo pipefail
cd "$(dirname "$0")/../.."
build=${1:-build/release}
GLARE_UPDATE_TEMPLATES=1 "$build/tests/glare_regression_tests"
git status --short tests/regression/templates
