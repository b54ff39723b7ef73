#include "adapters/mqtt/mqtt_client.hpp"

#include <cerrno>
#include <cstring>
#include <mutex>
#include <tuple>
#include <utility>

#include <mosquitto.h>
#include <poll.h>
#include <sys/socket.h>

namespace parlour::adapters::mqtt {

namespace {

using Tls = ServerOptions::Tls;

// At least once.
constexpr int quality_of_service = 1;
// How many publications may be without a receipt; the library keeps the rest.
constexpr unsigned in_flight = 100;
// How many packets one call of the library takes.
constexpr int one_packet = 1;

// A key with a password is refused: the library would ask for it at the
// terminal.
int no_password(char*, int, int, void*) {
  return 0;
}

// The library's counter is not made for several threads. It is never given
// back: the program ends with it.
void prepare_library() {
  static std::once_flag once;
  std::call_once(once, [] { mosquitto_lib_init(); });
}

const char* text_or_null(const std::string& text) {
  return text.empty() ? nullptr : text.c_str();
}

// MQTT 3.1.1, section 3.2.2.3.
const char* refusal_text(int code) {
  switch (code) {
  case 1:
    return "the server does not speak MQTT 3.1.1";
  case 2:
    return "the server does not accept the client-id";
  case 3:
    return "the server is not ready";
  case 4:
    return "the server does not accept user and password";
  case 5:
    return "the server does not let this user in";
  default:
    return "the server says no";
  }
}

// The library's sentences, without their full stops.
std::string text_of(int code, int system_error) {
  if (code == MOSQ_ERR_KEEPALIVE) // version 2.0.11 has no words for it
    return "it does not answer any more";
  std::string text = code == MOSQ_ERR_ERRNO ? std::strerror(system_error)
                                            : mosquitto_strerror(code);
  if (text.ends_with('.'))
    text.pop_back();
  return text;
}

} // namespace

// The library calls these within its functions; they only note what happens.
// An exception must not go through the library, so nothing is decided here.
struct MQTTClient::Calls {
  static MQTTClient& self(void* client) {
    return *static_cast<MQTTClient*>(client);
  }
  static void on_connect(mosquitto*, void* client, int code) {
    self(client).is_up_ = code == 0;
    self(client).refusal_ = code;
  }
  static void on_disconnect(mosquitto*, void* client, int) {
    self(client).is_lost_ = true;
  }
  static void on_message(mosquitto*, void* client,
                         const mosquitto_message* message) {
    const auto* bytes = static_cast<const char*>(message->payload);
    self(client).publications_.push_back(
        {message->topic,
         bytes
             ? std::string(bytes, static_cast<std::size_t>(message->payloadlen))
             : std::string(),
         message->retain});
  }
  static void on_publish(mosquitto*, void* client, int number) {
    self(client).receipts_.push_back(number);
  }
  static void on_log(mosquitto*, void* client, int level, const char* text) {
    // The first one tells most; what follows are its consequences.
    if (level == MOSQ_LOG_ERR && self(client).words_.empty())
      self(client).words_ = text;
  }
};

void MQTTClient::Delete::operator()(mosquitto* client) const {
  mosquitto_destroy(client);
}

Expected<void> MQTTClient::is_built_in() {
  return {};
}

MQTTClient::MQTTClient(const ServerOptions& options) : options_(options) {
  prepare_library();
  client_.reset(mosquitto_new(text_or_null(options_.client_id), true, this));
}

MQTTClient::~MQTTClient() = default;

// -- connecting ---------------------------------------------------------------

MQTTClient::Outcome MQTTClient::prepare() {
  auto* client = client_.get();
  mosquitto_connect_callback_set(client, Calls::on_connect);
  mosquitto_disconnect_callback_set(client, Calls::on_disconnect);
  mosquitto_message_callback_set(client, Calls::on_message);
  mosquitto_publish_callback_set(client, Calls::on_publish);
  mosquitto_log_callback_set(client, Calls::on_log);
  mosquitto_max_inflight_messages_set(client, in_flight);
  if (!options_.user.empty())
    if (const auto code = mosquitto_username_pw_set(
            client, options_.user.c_str(), text_or_null(options_.password));
        code != MOSQ_ERR_SUCCESS)
      return lost(code);
  return options_.tls == Tls::off ? Outcome() : prepare_tls();
}

// Without a file of authorities those of the machine count.
MQTTClient::Outcome MQTTClient::prepare_tls() {
  auto* client = client_.get();
  const auto& [ca, certificate, key] =
      std::tie(options_.tls_ca, options_.tls_certificate, options_.tls_key);
  const bool verifies = options_.tls == Tls::verify;
  auto code = ca.empty()
                  ? mosquitto_int_option(client, MOSQ_OPT_TLS_USE_OS_CERTS, 1)
                  : mosquitto_tls_set(client, ca.c_str(), nullptr,
                                      text_or_null(certificate),
                                      text_or_null(key), no_password);
  if (code == MOSQ_ERR_SUCCESS)
    code = mosquitto_tls_opts_set(client, verifies ? 1 : 0, nullptr, nullptr);
  return code == MOSQ_ERR_SUCCESS ? Outcome() : lost(code);
}

MQTTClient::Outcome MQTTClient::connect() {
  if (!client_)
    return fail(ErrorKind::network, std::strerror(errno));
  if (auto prepared = prepare(); !prepared)
    return prepared;
  const auto seconds =
      std::chrono::duration_cast<std::chrono::seconds>(options_.keep_alive);
  const auto code =
      mosquitto_connect_async(client_.get(), options_.host.c_str(),
                              options_.port, static_cast<int>(seconds.count()));
  // A negative number means that it has begun.
  if (code > 0)
    return lost(code);
  is_connecting_ = true;
  return {};
}

// The library does not notice that its socket is connected; with TLS it would
// wait for ever.
MQTTClient::Outcome MQTTClient::finish_connecting() {
  int error = 0;
  socklen_t size = sizeof error;
  getsockopt(socket(), SOL_SOCKET, SO_ERROR, &error, &size);
  if (error != 0)
    return fail(ErrorKind::network, std::strerror(error));
  is_connecting_ = false;
  return {};
}

// -- going on -----------------------------------------------------------------

// Reading also carries the handshake of TLS on, so it is done for both events
// until the server has let us in.
MQTTClient::Outcome MQTTClient::proceed(short events) {
  if (is_connecting_)
    if (auto connected = finish_connecting(); !connected)
      return connected;
  const bool shakes_hands = options_.tls != Tls::off && !is_up_;
  if ((events & POLLIN) != 0 || shakes_hands)
    if (auto read = judge(mosquitto_loop_read(client_.get(), one_packet));
        !read)
      return read;
  if ((events & POLLOUT) != 0)
    return judge(mosquitto_loop_write(client_.get(), one_packet));
  return {};
}

MQTTClient::Outcome MQTTClient::tend() {
  return judge(mosquitto_loop_misc(client_.get()));
}

void MQTTClient::say_goodbye() {
  if (is_up_)
    mosquitto_disconnect(client_.get());
}

// The library may have noticed a loss within a call that succeeded.
MQTTClient::Outcome MQTTClient::judge(int code) {
  if (code != MOSQ_ERR_SUCCESS)
    return lost(code);
  if (is_lost_ || socket() < 0)
    return lost(MOSQ_ERR_CONN_LOST);
  return {};
}

// What the server answered to the login tells more than that it hung up.
tl::unexpected<Error> MQTTClient::lost(int code) const {
  const int system_error = errno;
  if (refusal_ != 0)
    return fail(ErrorKind::network, refusal_text(refusal_));
  const auto text = text_of(code, system_error);
  return fail(ErrorKind::network,
              words_.empty() ? text : text + " (" + words_ + ")");
}

// -- messages -----------------------------------------------------------------

MQTTClient::Outcome MQTTClient::subscribe(const std::string& filter) {
  return judge(mosquitto_subscribe(client_.get(), nullptr, filter.c_str(),
                                   quality_of_service));
}

MQTTClient::Outcome MQTTClient::unsubscribe(const std::string& filter) {
  return judge(mosquitto_unsubscribe(client_.get(), nullptr, filter.c_str()));
}

Expected<int> MQTTClient::publish(const std::string& topic,
                                  const std::string& payload, bool retain) {
  int number = 0;
  const auto code = mosquitto_publish(
      client_.get(), &number, topic.c_str(), static_cast<int>(payload.size()),
      payload.data(), quality_of_service, retain);
  return judge(code).map([number] { return number; });
}

int MQTTClient::socket() const {
  return client_ ? mosquitto_socket(client_.get()) : -1;
}

short MQTTClient::interest() const {
  const bool writes = is_connecting_ || mosquitto_want_write(client_.get());
  return static_cast<short>(POLLIN | (writes ? POLLOUT : 0));
}

std::vector<Publication> MQTTClient::publications() {
  return std::exchange(publications_, {});
}

std::vector<int> MQTTClient::receipts() {
  return std::exchange(receipts_, {});
}

} // namespace parlour::adapters::mqtt
