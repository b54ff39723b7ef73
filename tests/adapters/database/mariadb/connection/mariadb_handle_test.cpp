#include <gtest/gtest.h>

#include "adapters/database/mariadb/connection/mariadb_handle.hpp"

namespace parlour::adapters {
namespace {

TEST(MariaDBHandleTest, IsNotConnectedYet) {
  for (const auto tls : {MariaDBOptions::Tls::off, MariaDBOptions::Tls::encrypt,
                         MariaDBOptions::Tls::verify}) {
    MariaDBOptions options;
    options.tls = tls;
    const MariaDBHandle handle(options);
    EXPECT_NE(handle.get(), nullptr);
    EXPECT_LT(handle.descriptor(), 0);
  }
}

} // namespace
} // namespace parlour::adapters
