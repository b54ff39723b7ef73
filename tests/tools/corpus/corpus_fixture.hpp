// An application for the tests of the corpus runner: it books a table when the
// user has confirmed, and answers questions about opening hours.
#pragma once

#include <memory>
#include <stdexcept>
#include <string>

#include "script/compiler/compiler.hpp"
#include "tests/support/paths.hpp"
#include "tests/support/temporary_folder.hpp"

namespace parlour::tools::corpus {

constexpr const char* table_application = R"xml(<dialogue>
  <topic name="Table">
    <slot name="People" type="Functional" question="How many?"
          confirm="never"/>
    <slot name="Time" type="Functional" question="When?" confirm="never"/>
    <slot name="Window"/>
    <filled><confirm question="A table?">
      <yes><try>
        <connectdb name="desk" param="" write="true"/>
        <querydb db="desk" param="insert into booking (time) values (?)"
                 args="this.Time"/>
        <speak param="It is booked."/>
        <catch><speak param="There is none."/><ask slot="Time"/></catch>
      </try></yes>
      <no><ask slot="Time"/></no>
    </confirm></filled>
  </topic>
  <topic name="Hours" kind="enquiry">
    <slot name="Day" confirm="never"/>
    <filled><speak param="At nine."/></filled>
  </topic>
  <handler name="Acts"><messages><component>
    <ASR><RecognitionResult><fire param="_LPARAM1"/></RecognitionResult></ASR>
    <Dialogue><request><throw expr="'no idea'"/></request>
      <help><consume/></help></Dialogue>
  </component></messages></handler>
</dialogue>)xml";

inline std::shared_ptr<const script::Program>
compile_table(const test::TemporaryFolder& folder) {
  folder.write("settings.xml",
               "<settings name='table'><Plugins/><Scripts>"
               "<Script>table.xml</Script></Scripts></settings>");
  folder.write("table.xml", table_application);
  script::CompileOptions options;
  options.platform = test::source_path("config/platform");
  const auto compiled = script::compile_application(folder.path(), options);
  std::string findings;
  for (const auto& finding : compiled.findings.all())
    findings += script::to_string(finding) + "\n";
  if (!compiled.program)
    throw std::runtime_error(findings);
  return compiled.program;
}

} // namespace parlour::tools::corpus
