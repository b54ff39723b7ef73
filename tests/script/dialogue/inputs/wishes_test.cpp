#include <functional>
#include <set>
#include <type_traits>
#include <utility>

#include <gtest/gtest.h>

#include "script/dialogue/inputs/wishes.hpp"

namespace parlour::dialogue {
namespace {

template <class Make>
std::uint64_t of(Make make) {
  Wishes wishes;
  make(wishes);
  return wishes.hash();
}

// One with this member, and else what it is by itself.
template <class T, class Member>
T changed(Member T::*member, std::type_identity_t<Member> value) {
  T one;
  one.*member = std::move(value);
  return one;
}

TEST(Wishes, EachCallCountsWithAllThatItSays) {
  const std::vector<std::function<void(Wishes&)>> calls = {
      [](Wishes&) {},
      [](Wishes& all) { all.post({}); },
      [](Wishes& all) { all.post(changed(&Message::command, "Go")); },
      [](Wishes& all) { all.post(changed(&Message::params, {1})); },
      [](Wishes& all) { all.post(changed(&Message::sinks, {"R"})); },
      [](Wishes& all) { all.post(changed(&Message::session, "s2")); },
      [](Wishes& all) { all.subscribe({}); },
      [](Wishes& all) {
        all.subscribe({{"Robot", "*"}});
      },
      [](Wishes& all) { all.release({}); },
      [](Wishes& all) { all.release(changed(&Output::text, "Hi.")); },
      [](Wishes& all) { all.start_timer(1, 2); },
      [](Wishes& all) { all.start_timer(2, 1); },
      [](Wishes& all) { all.cancel_timer(1); },
      [](Wishes& all) { all.query({}); },
      [](Wishes& all) { all.query(changed(&QueryRequest::sql, "select 1")); },
      [](Wishes& all) { all.query(changed(&QueryRequest::values, {1})); },
      [](Wishes& all) { all.query(changed(&QueryRequest::write, true)); },
      [](Wishes& all) { all.file(1, changed(&FileRequest::name, "a")); },
      [](Wishes& all) { all.file(1, changed(&FileRequest::text, "a")); },
      [](Wishes& all) { all.component({}); },
      [](Wishes& all) {
        all.component(changed(&ComponentRequest::load, false));
      },
      [](Wishes& all) { all.open_socket(changed(&SocketRequest::name, "a")); },
      [](Wishes& all) { all.send_socket(1, "a"); },
      [](Wishes& all) { all.close_socket(1); },
      [](Wishes& all) { all.ended(); },
  };
  std::set<std::uint64_t> hashes;
  for (const auto& call : calls) {
    EXPECT_EQ(of(call), of(call));
    hashes.insert(of(call));
  }
  EXPECT_EQ(hashes.size(), calls.size());
}

TEST(Wishes, TheirOrderCounts) {
  EXPECT_NE(of([](Wishes& all) {
              all.cancel_timer(1);
              all.close_socket(2);
            }),
            of([](Wishes& all) {
              all.close_socket(2);
              all.cancel_timer(1);
            }));
}

} // namespace
} // namespace parlour::dialogue
