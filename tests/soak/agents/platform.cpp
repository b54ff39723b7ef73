// soak_platform MESSAGES lines|zeromq EACH: the platform's side of the soak
// test. It prints where the agent connects, sends the numbers from 1 to
// MESSAGES, waits for as many from the agent, and prints as JSON what has
// become of them; before that a line at each EACH of them.
#include <chrono>
#include <cstdlib>
#include <deque>
#include <future>
#include <iostream>
#include <memory>

#include <nlohmann/json.hpp>

#include "adapters/agents/server/agent_server.hpp"
#include "tests/soak/agents/numbers.hpp"

namespace {

using namespace parlour;
using namespace parlour::adapters::agents;

// All but the constructor and figures() runs on the server's thread.
class Sender : public AgentServer::Component {
public:
  Sender(AgentServer& server, std::uint64_t total, std::uint64_t each)
      : server_(server), total_(total), each_(each), tally_(total) {}

  void online(const Hello&) override {
    ++online_;
    confirm();
    send_more();
  }
  void offline() override {
    ++offline_;
    if (std::exchange(is_done_, false))
      done_.set_value();
  }
  std::optional<WireError> received(AgentMessage message) override {
    const auto number = std::stoull(message.parameters.at(0));
    if (message.command == "Confirm") {
      confirmed_ = std::max<std::uint64_t>(confirmed_, number);
    } else {
      tally_.take(number, message.payload ? message.payload->bytes
                                          : message.parameters.at(1));
      if (tally_.count % each_ == 0)
        std::cout << tally_.count << std::endl;
      // The number of an echo is one that the agent has received.
      if (message.command == "Echo")
        confirmed_ = tally_.count;
      else if (tally_.count % soak::confirm_every == 0 || tally_.is_complete())
        confirm();
    }
    send_more();
    return {};
  }
  // It is sent again as soon as there is somebody, or room.
  void refused(const AgentMessage& message, const Error&) override {
    ++refused_;
    if (message.command == "Number")
      again_.push_back(std::stoull(message.session));
  }
  void failed(const std::string& reason) noexcept override {
    std::cerr << "failed: " << reason << '\n';
    std::_Exit(EXIT_FAILURE);
  }

  // Ready once all has arrived on both sides and the agent has gone.
  std::future<void> done() {
    return done_.get_future();
  }
  nlohmann::json figures() const {
    return {{"sent", total_},
            {"confirmed", confirmed_},
            {"received", tally_.count},
            {"missing", total_ - tally_.count},
            {"duplicates", tally_.duplicates},
            {"altered", tally_.altered},
            {"out_of_order", tally_.out_of_order},
            {"refused", refused_},
            {"online", online_},
            {"offline", offline_}};
  }

private:
  void confirm() {
    send("Confirm", tally_.count);
  }

  void send_more() {
    for (; !again_.empty(); again_.pop_front())
      send("Number", again_.front());
    while (next_ <= total_ && next_ <= confirmed_ + soak::window)
      send("Number", next_++);
    if (confirmed_ == total_ && tally_.is_complete() &&
        !std::exchange(is_done_, true))
      send("Stop", 0);
  }

  // The session tells the number where a message is refused.
  void send(const char* command, std::uint64_t number) {
    AgentMessage message;
    message.component = "Platform";
    message.command = command;
    message.sinks = {"Robot"};
    message.session = std::to_string(number);
    message.parameters = {std::to_string(number)};
    if (message.command != "Number") {
    } else if (soak::is_binary(number)) {
      message.kind = MessageKind::binary;
      message.payload = {"text/plain", soak::filler(number), {}};
    } else {
      message.parameters.push_back(soak::filler(number));
    }
    server_.send("Robot", std::move(message));
  }

  AgentServer& server_;
  const std::uint64_t total_;
  const std::uint64_t each_;
  soak::Tally tally_;
  std::uint64_t next_ = 1;
  std::uint64_t confirmed_ = 0;
  std::deque<std::uint64_t> again_;
  std::uint64_t refused_ = 0;
  std::uint64_t online_ = 0;
  std::uint64_t offline_ = 0;
  bool is_done_ = false;
  std::promise<void> done_;
};

int run(std::uint64_t total, const std::string& transport, std::uint64_t each) {
  ServerOptions options;
  options.accounts = {{"Robot", "", ""}};
  if (transport == "lines")
    options.lines = LineOptions();
  else
    options.zeromq = ServerOptions::ZeroMQ();
  auto server = AgentServer::start(std::move(options));
  if (!server) {
    std::cerr << server.error().message << '\n';
    return EXIT_FAILURE;
  }
  const auto began = std::chrono::steady_clock::now();
  const auto sender = std::make_shared<Sender>(**server, total, each);
  (*server)->attach("Robot", sender);
  std::cout << (*server)->addresses().at(0) << std::endl;
  sender->done().wait();
  (*server)->detach("Robot", sender.get());
  const std::chrono::duration<double> took =
      std::chrono::steady_clock::now() - began;
  auto figures = sender->figures();
  figures["mistakes"] = (*server)->mistakes();
  figures["seconds"] = took.count();
  std::cout << figures << std::endl;
  return EXIT_SUCCESS;
}

} // namespace

int main(int count, char** arguments) {
  if (count != 4) {
    std::cerr << "soak_platform MESSAGES lines|zeromq EACH\n";
    return EXIT_FAILURE;
  }
  return run(std::stoull(arguments[1]), arguments[2],
             std::stoull(arguments[3]));
}
