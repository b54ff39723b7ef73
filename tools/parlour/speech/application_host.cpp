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

} // namespace parlour::tools
