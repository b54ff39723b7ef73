// Wishes: a hash of what a conversation wants of its port, call by call. Two
// runs with the same wishes have said and asked the same. What only shows
// (inspections), what only reads (reachable), and what a replay computes itself
// (frames) is not in it. Numbers that the message centre gives later are not,
// either.
#pragma once

#include <cstdint>
#include <initializer_list>
#include <string_view>

#include "runtime/base/text/word_hash.hpp"
#include "script/dialogue/agenda/port.hpp"

namespace parlour::dialogue {

// Used by both ports, so that their hashes can be compared. Journals keep the
// hash: to change what goes into it makes older ones differ.
class Wishes {
public:
  void post(const Message& message);
  void subscribe(const std::vector<Subscription>& all);
  void release(const Output& output);
  void start_timer(TimerId id, Timestamp due);
  void cancel_timer(TimerId id);
  void query(const QueryRequest& request);
  void file(QueryId id, const FileRequest& request);
  void component(const ComponentRequest& request);
  void open_socket(const SocketRequest& request);
  void send_socket(SocketId id, const std::string& text);
  void close_socket(SocketId id);
  void ended();

  std::uint64_t hash() const {
    return hash_.value();
  }

private:
  // The letter tells the calls apart.
  void add(char call, std::initializer_list<std::uint64_t> numbers,
           std::initializer_list<std::string_view> texts = {});
  void add(const List& values);

  WordHash hash_;
};

} // namespace parlour::dialogue
