#include "tools/parlour/speech/application_host.hpp"

namespace parlour::tools {

ApplicationHost::ApplicationHost(const Application& of)
    : application_(of),
      columns_(column_reader(rehearsed(of.composition), of.folder, "")) {
  application = of.folder.string();
}

std::shared_ptr<const UnderstandingModel>
ApplicationHost::understanding() const {
  return application_.program->understanding;
}

Expected<std::vector<std::string>>
ApplicationHost::column(const std::string& name) const {
  return columns_(name);
}

// Who waits is told last.
void ApplicationHost::available(bool is_available) {
  told_ = is_available ? Told::available : Told::unavailable;
  TestHost::available(is_available);
}

} // namespace parlour::tools
