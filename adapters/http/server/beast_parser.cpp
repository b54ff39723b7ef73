// The only file that includes Boost.Beast, and of it only the parser: the loop
// waits for sockets, as for all others.
#include <string>

#include <boost/beast/http/parser.hpp>
#include <boost/beast/http/string_body.hpp>

#include "adapters/http/server/request_parser.hpp"

namespace parlour::adapters::http {

namespace {

namespace beast = boost::beast;

std::string text_of(beast::string_view text) {
  return {text.data(), text.size()};
}

// Fed piece by piece; knows no socket.
class BeastParser : public RequestParser {
public:
  explicit BeastParser(std::size_t max_body) {
    parser_.header_limit(max_head);
    parser_.body_limit(max_body);
    parser_.eager(true);
  }

  int take(std::string_view bytes) override {
    waiting_.append(bytes);
    beast::error_code error;
    // A call may stop between head and body.
    while (!error && !parser_.is_done() && !waiting_.empty())
      waiting_.erase(0, parser_.put(boost::asio::const_buffer(waiting_.data(),
                                                              waiting_.size()),
                                    error));
    if (parser_.is_done())
      return 200;
    if (!error || error == beast::http::error::need_more)
      return 0;
    return error == beast::http::error::body_limit     ? 413
           : error == beast::http::error::header_limit ? 431
                                                       : 400;
  }

  ReceivedRequest request() const override {
    using Field = beast::http::field;
    const auto& message = parser_.get();
    ReceivedRequest request;
    request.method = text_of(message.method_string());
    request.content_type = text_of(message[Field::content_type]);
    request.authorization = text_of(message[Field::authorization]);
    request.body = message.body();
    set_target(request, text_of(message.target()));
    return request;
  }

private:
  beast::http::request_parser<beast::http::string_body> parser_;
  // What has come and is not parsed yet: an incomplete line.
  std::string waiting_;
};

} // namespace

std::unique_ptr<RequestParser> make_request_parser(std::size_t limit) {
  return std::make_unique<BeastParser>(limit);
}

} // namespace parlour::adapters::http
