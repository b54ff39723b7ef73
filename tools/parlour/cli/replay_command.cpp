// `parlour replay`: repeats the sessions of a journal (docs/running.md).
#include <ostream>

#include <fmt/format.h>

#include "adapters/journal/journal_format.hpp"
#include "runtime/base/file_bytes.hpp"
#include "script/run/phrase_evaluator.hpp"
#include "tools/parlour/application/opening.hpp"
#include "tools/parlour/cli/commands.hpp"
#include "tools/parlour/console/exit_code.hpp"
#include "tools/parlour/journal/session_replay.hpp"

namespace parlour::tools {

namespace {

// True: all that was asked for was repeated, and was the same.
bool tell(const ReplayOutcome& outcome, const ReplayOptions& options,
          const Console& console) {
  if (outcome.torn > 0)
    say_warning(console,
                fmt::format("{}: the last record was not finished; its {} "
                            "bytes are left out",
                            options.journal, outcome.torn));
  if (outcome.others > 0)
    say_error(console,
              fmt::format("{} sessions were held with another state of {} and "
                          "cannot be repeated with this one: its scripts have "
                          "changed since",
                          outcome.others, options.app));
  if (outcome.sessions == 0 && outcome.others == 0)
    say_error(console,
              options.session.empty()
                  ? options.journal + " has no session"
                  : options.journal + " has no session " + options.session);
  if (outcome.sessions > 0)
    console.out << fmt::format(
        "{} of {} sessions are the same as they were, {} "
        "inputs\n",
        outcome.sessions - outcome.differ, outcome.sessions, outcome.inputs);
  return outcome.sessions > 0 && outcome.differ + outcome.others == 0;
}

} // namespace

int replay_command(const Places& places, const ReplayOptions& options,
                   const Console& console) {
  auto opened = open_application(places, options.app, console);
  if (const auto* status = std::get_if<int>(&opened))
    return *status;
  const auto& application = std::get<Application>(opened);
  const auto bytes =
      read_file(places.working / options.journal, adapters::max_journal_bytes);
  if (!bytes) {
    say_error(console, to_string(bytes.error()));
    return exit_code::usage;
  }
  const auto outcome = replay_sessions(
      *bytes, application.program,
      script::make_phrase_evaluator(application.program),
      {options.session, options.until, options.trace},
      [&](const std::string& line) { console.out << line << '\n'; });
  if (!outcome) {
    say_error(console, options.journal + ": " + outcome.error().message);
    return exit_code::wrong;
  }
  return tell(*outcome, options, console) ? exit_code::success
                                          : exit_code::wrong;
}

} // namespace parlour::tools
