// Visitor: plays one conversation with a server, and checks what it answers.
#pragma once

#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "adapters/web/text_client.hpp"
#include "tools/parlour/load/load_figures.hpp"
#include "tools/parlour/load/playable.hpp"

namespace parlour::tools {

namespace web = adapters::web;

struct VisitorParts {
  VisitorParts(web::TextClients& all, LoadFigures& of_all)
      : clients(all), figures(of_all) {}

  web::TextClients& clients;
  LoadFigures& figures;
  std::string address = "127.0.0.1";
  std::uint16_t port = 0;
  web::TextClients::By by = web::TextClients::By::frames;
  // How long an answer is waited for.
  Milliseconds patience{60'000};
  // Sessions are opened and then left as they are.
  bool idle = false;
  // Told once, by the first who is welcomed.
  std::uint64_t server = 0; // its process
  std::uint64_t memory_before = 0;
};

// Used on the clients' thread.
class Visitor : public web::Client {
public:
  using Moment = LoadFigures::Moment;
  // `over` is called once, and may destroy it. `due`: when it was to begin.
  Visitor(VisitorParts& parts, const Played& conversation, Moment due,
          std::function<void()> over);

  // Gives up where nothing has come for too long.
  void look(Moment now);
  // It has been welcomed and greeted.
  bool is_idle() const {
    return is_idle_;
  }

  void opened() override;
  void heard(const std::string& message) override;
  void closed(const std::string& why) override;

private:
  void connect();
  void welcome(std::uint64_t process);
  void said(const std::string& text);
  bool belongs_to_last(const std::string& text) const;
  void done(std::uint64_t turn);
  void ended();
  void go_on();
  void say();
  void is_wrong(const Step* expected, const std::string& found);
  void fail(const std::string& error);
  void finish();
  void leave();
  const PlayedTurn& turn() const {
    return conversation_.turns[at_];
  }

  VisitorParts& parts_;
  const Played& conversation_;
  std::function<void()> over_;
  std::unique_ptr<web::ClientLink> link_;
  std::size_t at_ = 0;               // of the turns
  std::size_t heard_ = 0;            // of its answers
  std::vector<std::string> taken_;   // what the last of these was about
  std::vector<std::string> waiting_; // of which the next pattern wants more
  std::uint64_t number_ = 0;         // of the turn in this session
  bool is_done_ = true;              // the server has told so
  bool has_ended_ = false;  // the session; the next turn begins another
  bool is_leaving_ = false; // it has said so; the server's end is awaited
  bool is_over_ = false;
  bool is_idle_ = false;
  Moment due_;  // when it was to begin, or the turn was to be said
  Moment last_; // something came
};

} // namespace parlour::tools
