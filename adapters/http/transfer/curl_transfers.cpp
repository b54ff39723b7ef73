// libcurl's interface for many transfers at once ("multi socket"): libcurl says
// which sockets and which moment it waits for, the loop waits, and tells
// libcurl what is ready. Nothing here blocks or polls.
#include <algorithm>
#include <map>
#include <memory>
#include <string_view>
#include <utility>

#include <curl/curl.h>
#include <poll.h>

#include "adapters/http/transfer/transfers.hpp"
#include "adapters/loop/alarm.hpp"
#include "adapters/loop/watch.hpp"

namespace parlour::adapters::http {

namespace {

using Kind = HttpFailure::Kind;

// All header lines of an answer together.
constexpr std::size_t max_headers = 64 << 10;
// A service that asks for a longer pause is not waited for anyway.
constexpr curl_off_t longest_retry_after = 86'400; // seconds

// One transfer: libcurl's handle, and what it fills while it runs.
// Owned by the transfers while it runs. libcurl holds pointers into it, so it
// never moves.
struct Transfer {
  explicit Transfer(std::size_t max) : max_answer(max) {}
  Transfer(const Transfer&) = delete;
  Transfer& operator=(const Transfer&) = delete;
  ~Transfer() {
    curl_easy_cleanup(easy);
    curl_slist_free_all(headers);
  }

  Transfers::Id id = 0;
  CURL* easy = nullptr;
  curl_slist* headers = nullptr;
  HttpRequest request; // libcurl refers to its body
  Transfers::Done done;
  const std::size_t max_answer;
  std::string body = {};
  std::size_t header_bytes = 0;
  bool is_too_large = false;
  // The empty line behind the headers has come.
  bool has_all_headers = false;
};

// To return less than was given makes libcurl end the transfer.
std::size_t take_body(char* bytes, std::size_t size, std::size_t count,
                      void* user) {
  auto& transfer = *static_cast<Transfer*>(user);
  const auto length = size * count;
  transfer.is_too_large = length > transfer.max_answer - transfer.body.size();
  if (transfer.is_too_large)
    return 0;
  transfer.body.append(bytes, length);
  return length;
}

// A connection that ends within the headers is no error to libcurl, so their
// end is noted. An answer such as "100 Continue" may precede the real one.
std::size_t take_header(char* bytes, std::size_t size, std::size_t count,
                        void* user) {
  auto& transfer = *static_cast<Transfer*>(user);
  const auto length = size * count;
  const std::string_view line(bytes, length);
  if (line.starts_with("HTTP/"))
    transfer.has_all_headers = false;
  else if (line == "\r\n" || line == "\n")
    transfer.has_all_headers = true;
  transfer.header_bytes += length;
  transfer.is_too_large = transfer.header_bytes > max_headers;
  return transfer.is_too_large ? 0 : length;
}

// The body is not copied: `request` lives as long as the handle.
void set_body(Transfer& transfer) {
  const auto& request = transfer.request;
  auto* easy = transfer.easy;
  const bool is_bare =
      request.method == Method::get || request.method == Method::remove;
  if (!is_bare) {
    curl_easy_setopt(easy, CURLOPT_POSTFIELDSIZE_LARGE,
                     static_cast<curl_off_t>(request.body.size()));
    curl_easy_setopt(easy, CURLOPT_POSTFIELDS, request.body.c_str());
  }
  if (request.method != Method::get && request.method != Method::post)
    curl_easy_setopt(easy, CURLOPT_CUSTOMREQUEST,
                     std::string(name_of(request.method)).c_str());
}

// An empty header has its own notation; a colon without a value removes one.
void set_headers(Transfer& transfer) {
  auto add = [&](const std::string& line) {
    transfer.headers = curl_slist_append(transfer.headers, line.c_str());
  };
  bool has_type = false;
  for (const auto& [name, value, is_secret] : transfer.request.headers) {
    auto line = name;
    line.append(value.empty() ? ";" : ": ").append(value);
    add(line);
    has_type = has_type || name == "Content-Type";
  }
  add("Expect:");
  if (!has_type)
    add("Content-Type:");
  curl_easy_setopt(transfer.easy, CURLOPT_HTTPHEADER, transfer.headers);
}

void set_bounds(Transfer& transfer, const TransferOptions& options,
                Milliseconds time) {
  auto* easy = transfer.easy;
  curl_easy_setopt(easy, CURLOPT_TIMEOUT_MS,
                   std::max<long>(1, static_cast<long>(time.count())));
  curl_easy_setopt(easy, CURLOPT_CONNECTTIMEOUT_MS,
                   static_cast<long>(options.connect_timeout.count()));
  curl_easy_setopt(easy, CURLOPT_MAXFILESIZE_LARGE,
                   static_cast<curl_off_t>(options.max_answer));
  curl_easy_setopt(easy, CURLOPT_PROTOCOLS_STR, "http,https");
  curl_easy_setopt(easy, CURLOPT_FOLLOWLOCATION, 0L);
  curl_easy_setopt(easy, CURLOPT_PATH_AS_IS, 1L);
  // libcurl itself repeats a request on a connection that it finds closed. One
  // that may not be repeated gets a connection of its own.
  if (!transfer.request.may_repeat)
    curl_easy_setopt(easy, CURLOPT_FRESH_CONNECT, 1L);
}

void set_security(Transfer& transfer, const TransferOptions& options) {
  auto* easy = transfer.easy;
  curl_easy_setopt(easy, CURLOPT_SSL_VERIFYPEER, 1L);
  curl_easy_setopt(easy, CURLOPT_SSL_VERIFYHOST, 2L);
  curl_easy_setopt(easy, CURLOPT_SSLVERSION, CURL_SSLVERSION_TLSv1_2);
  if (!options.authority.empty())
    curl_easy_setopt(easy, CURLOPT_CAINFO, options.authority.c_str());
  // Always said, so that the environment chooses none.
  curl_easy_setopt(easy, CURLOPT_PROXY, options.proxy.c_str());
}

void set_up(Transfer& transfer, const TransferOptions& options,
            Milliseconds time) {
  auto* easy = transfer.easy;
  curl_easy_setopt(easy, CURLOPT_PRIVATE, &transfer);
  curl_easy_setopt(easy, CURLOPT_URL, transfer.request.address.c_str());
  curl_easy_setopt(easy, CURLOPT_NOSIGNAL, 1L);
  curl_easy_setopt(easy, CURLOPT_USERAGENT, "Parlour");
  curl_easy_setopt(easy, CURLOPT_ACCEPT_ENCODING, "");
  curl_easy_setopt(easy, CURLOPT_WRITEFUNCTION, &take_body);
  curl_easy_setopt(easy, CURLOPT_WRITEDATA, &transfer);
  curl_easy_setopt(easy, CURLOPT_HEADERFUNCTION, &take_header);
  curl_easy_setopt(easy, CURLOPT_HEADERDATA, &transfer);
  set_body(transfer);
  set_headers(transfer);
  set_bounds(transfer, options, time);
  set_security(transfer, options);
}

// Whether the request may have left this machine: libcurl notes the moment
// before it sends anything.
bool was_sent(CURL* easy) {
  curl_off_t began = 0;
  curl_easy_getinfo(easy, CURLINFO_PRETRANSFER_TIME_T, &began);
  return began > 0;
}

// libcurl's own texts may contain parts of an address, so none of them is used.
HttpFailure failure(const Transfer& transfer, CURLcode code) {
  const bool sent = was_sent(transfer.easy);
  if (transfer.is_too_large || code == CURLE_FILESIZE_EXCEEDED)
    return {Kind::too_large,
            "answered with more than " + std::to_string(transfer.max_answer) +
                " bytes, or with too many headers",
            true};
  switch (code) {
  case CURLE_COULDNT_RESOLVE_HOST:
  case CURLE_COULDNT_RESOLVE_PROXY:
    return {Kind::unreachable, "is not known by that name", false};
  case CURLE_COULDNT_CONNECT:
    return {Kind::unreachable, "cannot be reached", false};
  case CURLE_OPERATION_TIMEDOUT:
    return sent ? HttpFailure{Kind::late, "has not answered in time", true}
                : HttpFailure{Kind::unreachable, "could not be reached in time",
                              false};
  case CURLE_PEER_FAILED_VERIFICATION:
  case CURLE_SSL_ISSUER_ERROR:
    return {Kind::insecure,
            "has a certificate that is not trusted, or not its own; the "
            "option 'ca' names another authority",
            false};
  case CURLE_SSL_CONNECT_ERROR:
  case CURLE_SSL_CACERT_BADFILE:
    return {Kind::insecure, "cannot be spoken to with TLS", false};
  case CURLE_UNSUPPORTED_PROTOCOL:
  case CURLE_WEIRD_SERVER_REPLY:
  case CURLE_BAD_CONTENT_ENCODING:
    return {Kind::not_http, "answered something that is no HTTP", sent};
  default:
    return {Kind::broken_off, "broke off the connection", sent};
  }
}

// What libcurl calls a success has all headers, or it was cut off.
TryOutcome outcome_of(Transfer& transfer, CURLcode code) {
  if (code != CURLE_OK || !transfer.has_all_headers)
    return tl::make_unexpected(failure(transfer, code));
  long status = 0;
  curl_easy_getinfo(transfer.easy, CURLINFO_RESPONSE_CODE, &status);
  curl_off_t seconds = 0;
  curl_easy_getinfo(transfer.easy, CURLINFO_RETRY_AFTER, &seconds);
  char* redirect = nullptr;
  curl_easy_getinfo(transfer.easy, CURLINFO_REDIRECT_URL, &redirect);
  HttpAnswer answer{static_cast<int>(status), std::move(transfer.body)};
  if (seconds > 0)
    answer.retry_after =
        std::chrono::seconds(std::min(seconds, longest_retry_after));
  answer.redirect = redirect ? redirect : "";
  return answer;
}

// libcurl calls on_socket and on_timer within its own functions: these only set
// watches and the alarm.
class CurlTransfers : public Transfers {
public:
  CurlTransfers(Loop& loop, CURLM* multi, TransferOptions options)
      : loop_(loop), multi_(multi), options_(std::move(options)),
        alarm_(loop, [this] { act(CURL_SOCKET_TIMEOUT, 0); }) {
    curl_multi_setopt(multi_, CURLMOPT_SOCKETFUNCTION, &on_socket);
    curl_multi_setopt(multi_, CURLMOPT_SOCKETDATA, this);
    curl_multi_setopt(multi_, CURLMOPT_TIMERFUNCTION, &on_timer);
    curl_multi_setopt(multi_, CURLMOPT_TIMERDATA, this);
  }
  // Handles go before the watches, which libcurl still calls for.
  ~CurlTransfers() override {
    for (auto& [id, transfer] : transfers_)
      curl_multi_remove_handle(multi_, transfer->easy);
    transfers_.clear();
    curl_multi_cleanup(multi_);
  }

  Id start(const HttpRequest& request, Milliseconds time, Done done) override {
    auto transfer = std::make_unique<Transfer>(options_.max_answer);
    transfer->id = ++last_id_;
    transfer->request = request;
    transfer->done = std::move(done);
    transfer->easy = curl_easy_init();
    auto& added =
        *transfers_.emplace(last_id_, std::move(transfer)).first->second;
    if (added.easy)
      set_up(added, options_, time);
    if (!added.easy || curl_multi_add_handle(multi_, added.easy) != CURLM_OK)
      fail_later(last_id_);
    return last_id_;
  }

  // The transfer goes last, as its handle refers to it.
  void cancel(Id id) override {
    const auto found = transfers_.find(id);
    if (found == transfers_.end())
      return;
    const auto transfer = std::move(found->second);
    transfers_.erase(found);
    curl_multi_remove_handle(multi_, transfer->easy);
  }

private:
  // A socket of libcurl, and what libcurl waits for.
  struct Socket {
    std::unique_ptr<Watch> watch;
    short wanted = 0;
  };

  // There is no memory.
  void fail_later(Id id) {
    loop_.post([this, id, alive = std::weak_ptr(alive_)] {
      if (!alive.lock())
        return;
      const auto found = transfers_.find(id);
      if (found == transfers_.end())
        return;
      const auto done = std::move(found->second->done);
      transfers_.erase(found);
      done(tl::make_unexpected(
          HttpFailure{Kind::refused, "cannot be asked now", false}));
    });
  }

  static int on_socket(CURL*, curl_socket_t socket, int what, void* user,
                       void*) {
    static_cast<CurlTransfers*>(user)->wait_for(socket, what);
    return 0;
  }

  static int on_timer(CURLM*, long milliseconds, void* user) {
    auto& self = *static_cast<CurlTransfers*>(user);
    self.alarm_.set(milliseconds < 0 ? Alarm::never
                                     : std::chrono::steady_clock::now() +
                                           Milliseconds(milliseconds));
    return 0;
  }

  // libcurl says once what it waits for; it is kept for the next time.
  void wait_for(curl_socket_t number, int what) {
    if (what == CURL_POLL_REMOVE) {
      sockets_.erase(number);
      return;
    }
    auto& socket = sockets_[number];
    if (!socket.watch)
      socket.watch = std::make_unique<Watch>(
          loop_, [this, number](short ready) { on_ready(number, ready); });
    socket.wanted = static_cast<short>((what & CURL_POLL_IN ? POLLIN : 0) |
                                       (what & CURL_POLL_OUT ? POLLOUT : 0));
    socket.watch->await(number, socket.wanted);
  }

  void on_ready(curl_socket_t number, short ready) {
    act(number, (ready & POLLIN ? CURL_CSELECT_IN : 0) |
                    (ready & POLLOUT ? CURL_CSELECT_OUT : 0));
    // A watch waits once; libcurl says nothing if it waits for the same again.
    const auto found = sockets_.find(number);
    if (found != sockets_.end())
      found->second.watch->await(number, found->second.wanted);
  }

  void act(curl_socket_t socket, int ready) {
    int running = 0;
    curl_multi_socket_action(multi_, socket, ready, &running);
    conclude();
  }

  // What is done may start others, so each is taken out first.
  void conclude() {
    int left = 0;
    while (const auto* const message = curl_multi_info_read(multi_, &left)) {
      if (message->msg != CURLMSG_DONE)
        continue;
      const auto code = message->data.result;
      char* user = nullptr;
      curl_easy_getinfo(message->easy_handle, CURLINFO_PRIVATE, &user);
      const auto id = reinterpret_cast<Transfer*>(user)->id;
      const auto found = transfers_.find(id);
      const auto transfer = std::move(found->second);
      transfers_.erase(found);
      auto outcome = outcome_of(*transfer, code);
      curl_multi_remove_handle(multi_, transfer->easy);
      transfer->done(std::move(outcome));
    }
  }

  Loop& loop_;
  CURLM* const multi_;
  const TransferOptions options_;
  Alarm alarm_;
  std::map<curl_socket_t, Socket> sockets_;
  std::map<Id, std::unique_ptr<Transfer>> transfers_;
  Id last_id_ = 0;
  // Gone with this object: what was posted then does nothing.
  const std::shared_ptr<bool> alive_ = std::make_shared<bool>(true);
};

} // namespace

// The library is set up once and for all, as its destruction is not safe beside
// other threads.
Expected<std::unique_ptr<Transfers>> curl_transfers(Loop& loop,
                                                    TransferOptions options) {
  static const auto ready = curl_global_init(CURL_GLOBAL_DEFAULT);
  auto* const multi = ready == CURLE_OK ? curl_multi_init() : nullptr;
  if (!multi)
    return fail(ErrorKind::limit, "libcurl cannot begin: there is no memory");
  return std::make_unique<CurlTransfers>(loop, multi, std::move(options));
}

} // namespace parlour::adapters::http
