#include <future>
#include <system_error>
#include <thread>
#include <utility>
#include <vector>

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

// A thread that could not be started counts for none: names are looked up as
// soon as there are threads again.
TEST(Resolver, SaysThatThereIsNoThread) {
  bool has_threads = false;
  Resolver resolver([&](std::function<void()> work) {
    if (!has_threads)
      throw std::system_error(
          std::make_error_code(std::errc::resource_unavailable_try_again));
    std::thread(std::move(work)).detach();
  });
  std::vector<Endpoints> answers;
  for (int i = 0; i < 10; ++i)
    resolver.resolve({"127.0.0.1", "80"}, [&](Endpoints found) {
      answers.push_back(std::move(found));
    });
  ASSERT_EQ(answers.size(), 10u);
  EXPECT_EQ(answers.back().error().kind, ErrorKind::limit);
  EXPECT_NE(answers.back().error().message.find("'127.0.0.1'"),
            std::string::npos);
  has_threads = true;
  std::promise<bool> is_found;
  resolver.resolve({"127.0.0.1", "80"}, [&](const Endpoints& found) {
    is_found.set_value(found.has_value());
  });
  EXPECT_TRUE(is_found.get_future().get());
}

// One of those that run takes it.
TEST(Resolver, NeedsNoThreadOfItsOwnForEachName) {
  std::function<void()> only;
  Resolver resolver([&](std::function<void()> work) {
    if (only)
      throw std::system_error(
          std::make_error_code(std::errc::resource_unavailable_try_again));
    only = std::move(work);
  });
  int found = 0;
  for (int i = 0; i < 3; ++i)
    resolver.resolve({"127.0.0.1", "80"}, [&](const Endpoints& endpoints) {
      found += endpoints ? 1 : 0;
    });
  EXPECT_EQ(found, 0);
  only();
  EXPECT_EQ(found, 3);
}

TEST(Resolver, GoesWithWhatIsUnderWay) {
  Resolver resolver;
  for (int i = 0; i < 20; ++i)
    resolver.resolve({"127.0.0.1", "80"}, [](const Endpoints&) {});
}

} // namespace
} // namespace parlour::adapters
