#include <future>
#include <utility>

#include <gtest/gtest.h>

#include "adapters/network/resolver.hpp"

namespace parlour::adapters {
namespace {

Endpoints resolve(const Address& address) {
  Resolver resolver;
  std::promise<Endpoints> answer;
  resolver.resolve(
      address, [&](Endpoints found) { answer.set_value(std::move(found)); });
  return answer.get_future().get();
}

TEST(Resolver, FindsNumbers) {
  const auto found = resolve({"127.0.0.1", "80"});
  ASSERT_TRUE(found);
  ASSERT_EQ(found->size(), 1u);
  EXPECT_EQ(found->front().address.ss_family, AF_INET);
}

TEST(Resolver, SaysThatThereIsNone) {
  // No name can have an empty part.
  const auto found = resolve({"no..such", "80"});
  ASSERT_FALSE(found);
  EXPECT_EQ(found.error().kind, ErrorKind::network);
  EXPECT_NE(found.error().message.find("'no..such' is not found"),
            std::string::npos);
}

TEST(Resolver, GoesWithWhatIsUnderWay) {
  Resolver resolver;
  for (int i = 0; i < 20; ++i)
    resolver.resolve({"127.0.0.1", "80"}, [](const Endpoints&) {});
}

} // namespace
} // namespace parlour::adapters
