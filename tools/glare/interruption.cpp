#include "interruption.h"

#include <csignal>

namespace glare::tool {

namespace {

volatile std::sig_atomic_t received_signal = 0;

void note_signal(int signal) { received_signal = signal; }

}  // namespace

void watch_for_interruption() {
  struct sigaction action = {};
  action.sa_handler = note_signal;
  action.sa_flags = static_cast<int>(SA_RESETHAND);  // A second signal ends the process at once.
  sigaction(SIGINT, &action, nullptr);
  sigaction(SIGTERM, &action, nullptr);
  std::signal(SIGXFSZ, SIG_IGN);
  std::signal(SIGPIPE, SIG_IGN);
}

bool interrupted() { return received_signal != 0; }

int interruption_exit_status() { return 128 + received_signal; }

}  // namespace glare::tool
