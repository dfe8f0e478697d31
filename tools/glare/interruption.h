// Ending in good order on SIGINT and SIGTERM.
#pragma once

namespace glare::tool {

/// From now on the first SIGINT and the first SIGTERM are noted instead of ending the process at
/// once, and a file-size limit shows as a failing write.
void watch_for_interruption();

/// True after SIGINT or SIGTERM. Long work asks this and stops.
bool interrupted();

/// 128 + the signal's number: 130 after SIGINT, 143 after SIGTERM.
int interruption_exit_status();

}  // namespace glare::tool
