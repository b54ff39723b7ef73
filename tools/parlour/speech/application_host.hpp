// ApplicationHost: a host for a component that runs alone, but may know the
// application as in a node.
#pragma once

#include <memory>

#include "runtime/plugin/test_host.hpp"
#include "tools/parlour/application/application.hpp"

namespace parlour::tools {

// The application must outlive it. Columns are read from a copy of its
// databases; there is no data folder.
class ApplicationHost : public TestHost {
public:
  explicit ApplicationHost(const Application& of);

  std::shared_ptr<const UnderstandingModel> understanding() const override;
  Expected<std::vector<std::string>>
  column(const std::string& name) const override;

private:
  const Application& application_;
  const ColumnReader columns_;
};

} // namespace parlour::tools
