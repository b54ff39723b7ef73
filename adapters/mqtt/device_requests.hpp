// DeviceRequests keeps the messages Set and Ask until they can be answered:
// until a device has said what it was asked, or shows that it has obeyed.
//
//  held     no connection yet, or devices are still announcing themselves
//  waiting  the device has been asked or told; it has not said anything yet
//
// Every request gets exactly one answer: State, or Failed after its time.
#pragma once

#include <list>
#include <string>
#include <vector>

#include "adapters/mqtt/deeds.hpp"
#include "adapters/mqtt/device_table.hpp"
#include "runtime/base/clock.hpp"

namespace parlour::adapters::mqtt {

// Not thread-safe. It refers to the table and the deeds, which must outlive it.
//
// An example: "switch the lamp in the kitchen on" is Set(lamp, kitchen, on).
// The lamp's command is published; its state ON is the answer. A lamp that
// never tells its state is believed as soon as the server has the command.
class DeviceRequests {
public:
  // How many may be without an answer; further ones fail at once.
  static constexpr std::size_t max_pending = 1'000;

  // `patience`: how long a request may take.
  DeviceRequests(DeviceTable& table, Deeds& deeds, Milliseconds patience)
      : table_(table), deeds_(deeds), patience_(patience) {}

  // Takes a message in. It is held until the next begin().
  void add(const Message& message, Moment now);
  // Begins all that are held: everything that can be known is known.
  void begin(Moment now);
  // The device's state was told. A `retained` one is from before, so it shows
  // nothing that was ordered since. Returns whether somebody was waiting for
  // it.
  bool told(const Device& device, bool retained, Moment now);
  // The server has got the publication.
  void published(Ticket ticket, Moment now);
  // The server does not get it.
  void not_published(Ticket ticket);
  // Fails those whose time is over.
  void expire(Moment now);
  void fail_all(const std::string& reason);

  bool has_held() const;
  // When to call expire(); max() for never.
  Moment next_moment() const;

private:
  // A device that has not obeyed or answered yet.
  struct Awaited {
    std::string id;
    // The states that show that it has obeyed.
    std::vector<Value> shown_by;
    // Its receipt counts as the answer: the device does not tell.
    Ticket receipt = 0;
    // What is published, whether or not the receipt counts.
    Ticket ticket = 0;
    // What it has said since.
    Value said;
    bool done = false;
  };
  // Owned by the list. `awaited` is empty while it is held.
  struct Request {
    Message message;
    bool sets = false;
    Spoken what;
    Value value;
    Moment deadline;
    bool held = true;
    std::vector<Awaited> awaited;
    // It is only still in the list: end_those() forgets it.
    bool answered = false;
  };
  using Requests = std::list<Request>;

  // Each returns whether the request is answered.
  bool begin(Request& request, Moment now);
  bool begin_ask(Request& request, const std::vector<Device*>& found,
                 Moment now);
  bool begin_set(Request& request, std::vector<Device*> found);
  bool told(Request& request, const Device& device, bool retained, Moment now,
            bool& was_awaited);
  bool obeyed(Request& request);
  void late(Request& request);

  void supersede(const Request& by);
  bool publish(Request& request, const std::vector<Device*>& found);
  void answer_state(const Request& request, const Value& value);
  void fail(const Request& request, const std::string& reason);
  template <class Ends>
  void end_those(Ends ends);

  DeviceTable& table_;
  Deeds& deeds_;
  const Milliseconds patience_;
  Requests requests_;
  Ticket last_ticket_ = 0;
};

} // namespace parlour::adapters::mqtt
