// `parlour replay`: repeats the sessions of a journal (docs/running.md).
#include <ostream>

#include <fmt/format.h>

#include "script/run/phrase_evaluator.hpp"
#include "tools/parlour/application/opening.hpp"
#include "tools/parlour/cli/commands.hpp"
#include "tools/parlour/cli/run/journal_damage.hpp"
#include "tools/parlour/console/exit_code.hpp"
#include "tools/parlour/journal/journal_sessions.hpp"
#include "tools/parlour/journal/session_replay.hpp"

namespace parlour::tools {

namespace {

// True: all that was asked for was repeated, and was the same.
bool tell(const ReplayOutcome& outcome, const ReplayOptions& options,
          const Console& console) {
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
  const auto journal = read_sessions(places.working / options.journal,
                                     dialogue::HistoryFrom::beginning);
  if (!journal) {
    say_error(console, to_string(journal.error()));
    return exit_code::usage;
  }
  tell_damage(*journal, options.journal, console);
  const auto outcome = replay_sessions(
      journal->sessions, application.program,
      script::make_phrase_evaluator(application.program),
      {options.session, options.until, options.trace},
      [&](const std::string& line) { console.out << line << '\n'; });
  const bool all_same = tell(outcome, options, console);
  return all_same && journal->damages.empty() ? exit_code::success
                                              : exit_code::wrong;
}

} // namespace parlour::tools
