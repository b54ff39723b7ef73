// trial_component: the process of a component that misbehaves on request. It
// serves the plug-in Trial on the socket that it inherits; the option `start`
// and the commands choose what goes wrong.
#include <cstdlib>
#include <stdexcept>
#include <thread>

#include <sys/socket.h>
#include <unistd.h>

#include "adapters/process/child_process.hpp"
#include "adapters/process/component_server.hpp"

namespace {

using namespace parlour;

class Trial : public IPlugin {
protected:
  Expected<void> on_start(const Options& options) override {
    const auto found = options.find("start");
    const auto way = found == options.end() ? "" : found->second;
    if (way == "throw")
      throw std::runtime_error("cannot be made");
    if (way == "hang")
      pause();
    if (way == "exit")
      _exit(1);
    if (way == "refuse")
      return fail(ErrorKind::database, "no such file", {"a.db", 3, 1});
    return {};
  }

  void on_message(const Message& message) override {
    using Deed = void (Trial::*)(const Message&);
    static const std::map<std::string, Deed> deeds = {
        {"Echo", &Trial::echo},       {"Throw", &Trial::give_up},
        {"Hang", &Trial::hang},       {"Exit", &Trial::exit},
        {"Abort", &Trial::abort},     {"Rubbish", &Trial::rubbish},
        {"Close", &Trial::close},     {"Later", &Trial::later},
        {"Think", &Trial::think},     {"Column", &Trial::column},
        {"Words", &Trial::words},     {"Tell", &Trial::tell},
        {"Broken", &Trial::broken},   {"Large", &Trial::large},
        {"Ask", &Trial::ask_another}, {"Flood", &Trial::flood},
        {"Many", &Trial::many}};
    (this->*deeds.at(message.command))(message);
  }

private:
  void echo(const Message& message) {
    fire_event("Echoed", message.params);
  }
  void give_up(const Message&) {
    throw std::runtime_error("engine trouble");
  }
  void hang(const Message&) {
    for (;;)
      pause();
  }
  void exit(const Message&) {
    _exit(1);
  }
  void abort(const Message&) {
    std::abort();
  }
  void rubbish(const Message&) {
    const std::string bytes(64, '\x7f');
    (void)!write(adapters::component_socket, bytes.data(), bytes.size());
  }
  void close(const Message&) {
    shutdown(adapters::component_socket, SHUT_WR);
    hang({});
  }
  // Delays three calls; the first one cancels the second.
  void later(const Message& message) {
    const auto second =
        host().after(Milliseconds(2000), [=, this] { answer(message, "Two"); });
    host().after(Milliseconds(1000), [=, this] {
      host().cancel(second);
      answer(message, "One", {host().clock().now()});
    });
    host().after(Milliseconds(3000),
                 [] { throw std::runtime_error("too late"); });
  }
  void think(const Message& message) {
    std::thread([this, message] { answer(message, "Thought"); }).detach();
  }
  void column(const Message& message) {
    const auto values = host().column(message.params.at(0).text());
    fire_event("Column",
               {values ? Value(static_cast<std::int64_t>(values->size()))
                       : Value(values.error().message)});
  }
  void words(const Message& message) {
    const auto phrases = host().phrases();
    if (!phrases)
      return fire_event("Words", {"nobody"});
    const auto [words, failures] = phrases->render(message.params.at(0));
    fire_event("Words", {words ? *words : failures.at(0).message});
  }
  void tell(const Message&) {
    host().log("told");
    Message message;
    message.command = "Call";
    message.sinks = {"Telephone"};
    send_message(message);
    const auto model = host().understanding();
    fire_event("Told", {host().data_folder(), host().application_folder(),
                        host().clock().now(),
                        model ? model->topics.at(0).slots.at(0).name : ""});
  }
  void ask_another(const Message& message) {
    ask("Database", "Query", message.params, [=, this](auto outcome) {
      answer(
          message, "Answered",
          {outcome ? outcome->params.at(0) : Value(outcome.error().message)});
    });
  }
  void broken(const Message&) {
    host().failed("my device is gone");
  }
  void large(const Message&) {
    fire_event("Large", {std::string(adapters::longest_ipc_message, 'x')});
  }
  void flood(const Message& message) {
    for (int i = 0; i < message.params.at(0).integer_or(0); ++i)
      fire_event("Drop", {i});
  }
  void many(const Message&) {
    for (int i = 0; i < 10'001; ++i)
      host().after(Milliseconds(1000), [] {});
  }
};

} // namespace

int main() {
  PluginFactory factory;
  factory.description.name = "Trial";
  factory.create = [] { return std::make_unique<Trial>(); };
  return adapters::serve_component(adapters::component_socket, factory);
}
