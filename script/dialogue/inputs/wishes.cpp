#include "script/dialogue/inputs/wishes.hpp"

#include "runtime/base/value_bytes.hpp"

namespace parlour::dialogue {

void Wishes::add(char call, std::initializer_list<std::uint64_t> numbers,
                 std::initializer_list<std::string_view> texts) {
  hash_.add(static_cast<std::uint64_t>(call));
  for (const auto number : numbers)
    hash_.add(number);
  for (const auto text : texts)
    hash_.add(text);
}

// The values as bytes (value_bytes.hpp), so that type and place of each of them
// count.
void Wishes::add(const List& values) {
  ByteWriter bytes;
  for (const auto& value : values)
    write(bytes, value);
  hash_.add(bytes.take());
}

// The message centre stamps it later, so time and number are left out.
void Wishes::post(const Message& message) {
  add('p', {message.correlation, message.sinks.size()},
      {message.source, message.command, message.session});
  for (const auto& sink : message.sinks)
    hash_.add(sink);
  add(message.params);
}

void Wishes::subscribe(const std::vector<Subscription>& all) {
  add('+', {all.size()});
  for (const auto& one : all)
    add(' ', {}, {one.source, one.command});
}

void Wishes::release(const Output& output) {
  add('!',
      {output.id, static_cast<std::uint64_t>(output.act), output.topic,
       output.slot, output.interruptible},
      {output.text});
}

void Wishes::start_timer(TimerId id, Timestamp due) {
  add('t', {id, static_cast<std::uint64_t>(due)});
}

void Wishes::cancel_timer(TimerId id) {
  add('c', {id});
}

void Wishes::query(const QueryRequest& request) {
  add('q',
      {request.id, static_cast<std::uint64_t>(request.kind), request.write},
      {request.database, request.sql});
  add(request.values);
}

void Wishes::file(QueryId id, const FileRequest& request) {
  add('f', {id, static_cast<std::uint64_t>(request.action), request.max_bytes},
      {request.name, request.text});
}

void Wishes::component(const ComponentRequest& request) {
  add('l', {request.id, request.load}, {request.plugin, request.name});
}

void Wishes::open_socket(const SocketRequest& request) {
  add('o',
      {request.id, request.order.lines,
       static_cast<std::uint64_t>(request.order.timeout.count())},
      {request.name, request.order.address});
}

void Wishes::send_socket(SocketId id, const std::string& text) {
  add('s', {id}, {text});
}

void Wishes::close_socket(SocketId id) {
  add('x', {id});
}

void Wishes::ended() {
  add('e', {});
}

} // namespace parlour::dialogue
