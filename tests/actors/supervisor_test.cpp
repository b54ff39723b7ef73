#include "actors/supervisor.hpp"
#include "tests/actors/bench.hpp"

namespace parlour::actors {
namespace {

TEST(Supervisor, CountsLogsAndTells) {
  Bench bench;
  bench.services.centre = bench.centre_probe();
  auto actor = bench.spawn(supervisor, &bench.services);
  for (const auto* name : {"Ear", "Mouth", "Ear"})
    bench.send(actor, component_failed{name, "worn", bench.work()});
  EXPECT_THAT(bench.logs, ElementsAre("Ear failed: worn", "Mouth failed: worn",
                                      "Ear failed: worn"));
  EXPECT_THAT(bench.seen, ElementsAre("System.ComponentFailed(Ear, worn, 1)",
                                      "System.ComponentFailed(Mouth, worn, 1)",
                                      "System.ComponentFailed(Ear, worn, 2)"));
}

} // namespace
} // namespace parlour::actors
