// `parlour schema`: prints what script/schema makes from the element table.
#include <ostream>

#include "script/schema/relax_ng.hpp"
#include "script/schema/xml_schema.hpp"
#include "tools/parlour/cli/commands.hpp"
#include "tools/parlour/console/exit_code.hpp"

namespace parlour::tools {

int schema_command(const SchemaOptions& options, const Console& console) {
  console.out << (options.xsd ? script::xml_schema()
                              : script::relax_ng_schema());
  console.out.flush();
  return exit_code::success;
}

} // namespace parlour::tools
