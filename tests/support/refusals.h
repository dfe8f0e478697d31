// Refusals, as tests expect them.
#pragma once

#include <gtest/gtest.h>

#include <string>

#include "glare/base/error.h"

namespace glare::test {

/// `call()` throws an `OptionError` that names `name`.
template <typename Call>
void expect_refused(const Call& call, const std::string& name) {
  try {
    call();
    ADD_FAILURE() << name << " was accepted";
  } catch (const OptionError& error) {
    EXPECT_NE(std::string(error.what()).find(name), std::string::npos) << error.what();
  }
}

}  // namespace glare::test
