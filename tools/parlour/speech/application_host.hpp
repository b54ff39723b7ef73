// ApplicationHost: a host for a component that runs alone, but may know the
// application as in a node.
#pragma once

#include <atomic>
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
  void available(bool is_available) override;

  // Whether the component has said that it can take messages.
  bool is_surely_available() const {
    return told_ == Told::available;
  }
  bool is_surely_unavailable() const {
    return told_ == Told::unavailable;
  }

private:
  enum class Told : std::uint8_t { nothing, available, unavailable };

  const Application& application_;
  const ColumnReader columns_;
  std::atomic<Told> told_ = Told::nothing;
};

} // namespace parlour::tools
