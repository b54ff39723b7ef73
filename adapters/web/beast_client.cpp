// The links of visitors: lines, or frames of a WebSocket.
#include <map>
#include <string>
#include <utility>
#include <vector>

#include <boost/asio/buffer.hpp>
#include <boost/asio/post.hpp>
#include <boost/asio/read_until.hpp>
#include <boost/asio/write.hpp>
#include <boost/beast/core/buffers_to_string.hpp>
#include <boost/beast/core/flat_buffer.hpp>
#include <boost/beast/websocket.hpp>

#include "adapters/web/beast_parts.hpp"
#include "adapters/web/text_client.hpp"

namespace parlour::adapters::web {

namespace {

namespace beast = boost::beast;

// What the handlers share with the link, which may be destroyed before them.
//
// One message is written at a time; the others wait. Messages that are sent
// before the connection is open wait, too.
class Talk : public std::enable_shared_from_this<Talk> {
public:
  explicit Talk(Client& client) : client_(&client) {}
  virtual ~Talk() = default;

  virtual void connect(const tcp::endpoint& end) = 0;
  virtual void close() = 0;

  // Called by the link that goes: nobody hears of anything any more.
  void forget() {
    client_ = nullptr;
    close();
  }
  void send(std::string message) {
    waiting_.push_back(std::move(message));
    write();
  }
  // The client hears it once; it may destroy its link in the call.
  void over(const ErrorCode& error) {
    close();
    if (auto* client = std::exchange(client_, nullptr))
      client->closed(error.message());
  }

protected:
  virtual void write_some(const std::string& message) = 0;

  void open() {
    is_open_ = true;
    if (client_)
      client_->opened();
  }
  void hear(const std::string& message) {
    if (client_)
      client_->heard(message);
  }
  void wrote(const ErrorCode& error) {
    is_sending_ = false;
    if (error)
      over(error);
    else
      write();
  }
  // Nothing is sent while another message is on its way.
  void write() {
    if (!is_open_ || is_sending_ || waiting_.empty())
      return;
    is_sending_ = true;
    sending_ = std::move(waiting_.front());
    waiting_.erase(waiting_.begin());
    write_some(sending_);
  }

private:
  Client* client_; // null: nobody listens any more
  std::vector<std::string> waiting_;
  std::string sending_;
  bool is_open_ = false;
  bool is_sending_ = false;
};

// The line end is added here, and taken off what comes.
class LineTalk : public Talk {
public:
  LineTalk(net::io_context& context, Client& client)
      : Talk(client), socket_(context) {}

  void connect(const tcp::endpoint& end) override {
    socket_.async_connect(end, [kept = self()](ErrorCode error) {
      if (error)
        return kept->over(error);
      kept->socket_.set_option(tcp::no_delay(true), error);
      kept->open();
      kept->read();
    });
  }
  void close() override {
    ErrorCode ignored;
    socket_.close(ignored);
  }

private:
  std::shared_ptr<LineTalk> self() {
    return std::static_pointer_cast<LineTalk>(shared_from_this());
  }
  void read() {
    net::async_read_until(socket_, net::dynamic_buffer(in_), '\n',
                          [kept = self()](ErrorCode error, std::size_t size) {
                            if (error)
                              return kept->over(error);
                            const auto line = kept->in_.substr(0, size - 1);
                            kept->in_.erase(0, size);
                            kept->hear(line);
                            kept->read();
                          });
  }
  void write_some(const std::string& message) override {
    out_ = message + '\n';
    net::async_write(
        socket_, net::buffer(out_),
        [kept = self()](ErrorCode error, std::size_t) { kept->wrote(error); });
  }

  Socket socket_;
  std::string in_;
  std::string out_;
};

// The message that is written must stay in place: Talk keeps it.
class FrameTalk : public Talk {
public:
  FrameTalk(net::io_context& context, Client& client)
      : Talk(client), stream_(context) {}

  void connect(const tcp::endpoint& end) override {
    stream_.next_layer().async_connect(end, [kept = self()](ErrorCode error) {
      if (error)
        return kept->over(error);
      kept->stream_.next_layer().set_option(tcp::no_delay(true), error);
      kept->shake_hands();
    });
  }
  void close() override {
    ErrorCode ignored;
    stream_.next_layer().close(ignored);
  }

private:
  std::shared_ptr<FrameTalk> self() {
    return std::static_pointer_cast<FrameTalk>(shared_from_this());
  }
  void shake_hands() {
    stream_.async_handshake("localhost", "/", [kept = self()](ErrorCode error) {
      if (error)
        return kept->over(error);
      kept->stream_.text(true);
      kept->open();
      kept->read();
    });
  }
  void read() {
    stream_.async_read(buffer_, [kept = self()](ErrorCode error, std::size_t) {
      if (error)
        return kept->over(error);
      const auto text = beast::buffers_to_string(kept->buffer_.data());
      kept->buffer_.consume(kept->buffer_.size());
      kept->hear(text);
      kept->read();
    });
  }
  void write_some(const std::string& message) override {
    stream_.async_write(
        net::buffer(message),
        [kept = self()](ErrorCode error, std::size_t) { kept->wrote(error); });
  }

  beast::websocket::stream<Socket> stream_;
  beast::flat_buffer buffer_;
};

// What the tool holds: it only lets the talk go, which may live on in a
// handler.
class Link : public ClientLink {
public:
  explicit Link(std::shared_ptr<Talk> talk) : talk_(std::move(talk)) {}
  ~Link() override {
    talk_->forget();
  }
  void send(std::string message) override {
    talk_->send(std::move(message));
  }

private:
  std::shared_ptr<Talk> talk_;
};

// One timer serves all moments: thousands of visitors have one each.
class BeastClients : public TextClients {
public:
  void run() override {
    const auto stays = net::make_work_guard(context_);
    context_.restart();
    context_.run();
  }
  void stop() override {
    context_.stop();
  }

  std::unique_ptr<ClientLink> connect(const std::string& address,
                                      std::uint16_t port, By by,
                                      Client& client) override {
    std::shared_ptr<Talk> talk;
    if (by == By::lines)
      talk = std::make_shared<LineTalk>(context_, client);
    else
      talk = std::make_shared<FrameTalk>(context_, client);
    net::post(context_, [this, talk, address, port] {
      ErrorCode error;
      const auto found = find(address, error);
      if (error)
        talk->over(error);
      else
        talk->connect({found, port});
    });
    return std::make_unique<Link>(talk);
  }

  // Those of one moment in the order in which they were asked for.
  void at(Moment moment, std::function<void()> action) override {
    due_.emplace(moment, std::move(action));
    if (due_.begin()->first == moment)
      await();
  }

private:
  // Looked up once for all visitors, who wait meanwhile.
  net::ip::address find(const std::string& name, ErrorCode& error) {
    const auto known = addresses_.find(name);
    if (known != addresses_.end())
      return known->second;
    auto address = net::ip::make_address(name, error);
    if (error) {
      const auto found = tcp::resolver(context_).resolve(name, "", error);
      if (error)
        return {};
      address = found.begin()->endpoint().address();
    }
    return addresses_.emplace(name, address).first->second;
  }
  void await() {
    timer_.expires_at(due_.begin()->first);
    timer_.async_wait([this](ErrorCode error) {
      if (!error)
        act();
    });
  }
  // An action may ask for further moments, also for earlier ones.
  void act() {
    while (!due_.empty() && due_.begin()->first <= SteadyClock::now())
      due_.extract(due_.begin()).mapped()();
    if (!due_.empty())
      await();
  }

  net::io_context context_{1};
  Timer timer_{context_};
  std::multimap<Moment, std::function<void()>> due_;
  std::map<std::string, net::ip::address> addresses_;
};

} // namespace

Expected<std::unique_ptr<TextClients>> TextClients::start() {
  return std::make_unique<BeastClients>();
}

} // namespace parlour::adapters::web
