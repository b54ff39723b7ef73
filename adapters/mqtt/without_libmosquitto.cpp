// What takes the place of mqtt_client.cpp where libmosquitto is missing.
#include "adapters/mqtt/mqtt_client.hpp"

struct mosquitto {};

namespace parlour::adapters::mqtt {

void MQTTClient::Delete::operator()(mosquitto* client) const {
  delete client;
}

Expected<void> MQTTClient::is_built_in() {
  return fail(ErrorKind::settings,
              "this program was built without libmosquitto, so it can reach no "
              "MQTT server; install libmosquitto-dev and build it again, or "
              "use LogDevices");
}

MQTTClient::MQTTClient(const ServerOptions& options) : options_(options) {}

MQTTClient::~MQTTClient() = default;

MQTTClient::Outcome MQTTClient::connect() {
  return is_built_in();
}

MQTTClient::Outcome MQTTClient::proceed(short) {
  return is_built_in();
}

MQTTClient::Outcome MQTTClient::tend() {
  return is_built_in();
}

void MQTTClient::say_goodbye() {}

MQTTClient::Outcome MQTTClient::subscribe(const std::string&) {
  return is_built_in();
}

MQTTClient::Outcome MQTTClient::unsubscribe(const std::string&) {
  return is_built_in();
}

Expected<int> MQTTClient::publish(const std::string&, const std::string&,
                                  bool) {
  return is_built_in().map([] { return 0; });
}

int MQTTClient::socket() const {
  return -1;
}

short MQTTClient::interest() const {
  return 0;
}

std::vector<Publication> MQTTClient::publications() {
  return {};
}

std::vector<int> MQTTClient::receipts() {
  return {};
}

} // namespace parlour::adapters::mqtt
