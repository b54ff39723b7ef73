#include "tools/bench/database/query_workload.hpp"

#include <limits>
#include <string>
#include <utility>
#include <vector>

#include "script/compiler/compiler.hpp"
#include "script/program/computing_host.hpp"
#include "script/vm/interpreter.hpp"
#include "tools/bench/support/desk.hpp"

namespace parlour::tools {

namespace {

// One session: a script whose queries are sent to the component, and which
// waits for the answers.
class Asking : public script::LonelyHost {
public:
  Asking(const std::shared_ptr<const script::Program>& program,
         IPlugin& component, std::size_t number)
      : interpreter_(program), component_(component) {
    query_.source = "Session";
    query_.command = "Query";
    query_.sinks = {"Database"};
    query_.session = "0000000000000000";
    query_.correlation = number;
    interpreter_.limit_instructions(std::numeric_limits<std::int64_t>::max());
    interpreter_.new_event();
  }

  // Starts the script with a range of queries. True if it waits for an answer.
  Expected<bool> begin(std::size_t first, std::size_t count) {
    const auto work = interpreter_.program().functions.find("work")->second;
    activation_ = interpreter_.start(work,
                                     {Value(static_cast<std::int64_t>(first)),
                                      Value(static_cast<std::int64_t>(count))},
                                     {});
    return judge(interpreter_.run(*activation_, *this));
  }
  Expected<bool> go_on(const Message& event) {
    if (event.command != "Result" || event.params.empty())
      return fail(ErrorKind::database, event.params.empty()
                                           ? event.command
                                           : event.params.back().text());
    return judge(interpreter_.resume(*activation_, event.params[0], *this));
  }
  std::int64_t letters() const {
    return letters_;
  }

  // The only effect of the workload is a query: it is sent, and the script
  // waits.
  script::Performed perform(script::Activation&,
                            const script::Effect& effect) override {
    query_.params.clear();
    query_.params.push_back(effect.operand(0));
    query_.params.push_back(effect.operand(1));
    query_.params.emplace_back(false);
    component_.receive(query_);
    return script::Waits{};
  }
  Timestamp now() const override {
    return 0;
  }
  double random() override {
    return 0;
  }

private:
  // Runs on after each slice. The result of a script is its count of letters.
  Expected<bool> judge(script::RunResult result) {
    while (result.status == script::RunStatus::yielded)
      result = interpreter_.run(*activation_, *this);
    if (result.status == script::RunStatus::failed)
      return tl::make_unexpected(result.error);
    letters_ = result.value.integer_or(0);
    return result.status == script::RunStatus::waiting;
  }

  script::Interpreter interpreter_;
  IPlugin& component_;
  // The same for all queries but for its parameters.
  Message query_;
  std::unique_ptr<script::Activation> activation_;
  std::int64_t letters_ = 0;
};

using Sessions = std::vector<std::unique_ptr<Asking>>;

// Starts all sessions, then lets each go on with its answers until all have
// ended.
Expected<void> converse(Sessions& sessions, Desk& desk, std::size_t count) {
  std::size_t waiting = 0;
  for (std::size_t i = 0; i < sessions.size(); ++i) {
    // The queries are divided evenly among the sessions.
    const auto first = count * i / sessions.size();
    const auto end = count * (i + 1) / sessions.size();
    const auto begun = sessions[i]->begin(first, end - first);
    if (!begun)
      return tl::make_unexpected(begun.error());
    waiting += *begun ? 1u : 0u;
  }
  std::vector<Message> events;
  while (waiting > 0) {
    desk.take(events);
    for (const auto& event : events) {
      const auto goes_on = sessions[event.correlation]->go_on(event);
      if (!goes_on)
        return tl::make_unexpected(goes_on.error());
      waiting -= *goes_on ? 0u : 1u;
    }
  }
  return {};
}

} // namespace

Expected<QueryWorkload> QueryWorkload::load(const std::filesystem::path& file) {
  auto compiled = script::compile_file(file, {});
  if (!compiled.program)
    return fail(ErrorKind::compile,
                script::to_string(compiled.findings.all().front()));
  return QueryWorkload(std::move(compiled.program));
}

Expected<Measured> QueryWorkload::run(IPlugin& component, Desk& desk,
                                      int server, std::size_t sessions,
                                      std::size_t count) const {
  Sessions asking;
  for (std::size_t i = 0; i < sessions; ++i)
    asking.push_back(std::make_unique<Asking>(program_, component, i));
  // Statements are prepared, and memory is allocated, before the measurement.
  if (auto warm = converse(asking, desk, 20 * sessions); !warm)
    return tl::make_unexpected(warm.error());
  const StopWatch watch(server);
  const auto done = converse(asking, desk, count);
  if (!done)
    return tl::make_unexpected(done.error());
  std::int64_t letters = 0;
  for (const auto& one : asking)
    letters += one->letters();
  return watch.stop(count, std::to_string(letters));
}

} // namespace parlour::tools
