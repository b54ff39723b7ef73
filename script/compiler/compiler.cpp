// The order of a compilation: settings, then scripts, then the platform's
// libraries, and finally declarations (finish). Each step goes on after errors
// of the previous one as far as that makes sense, so that all findings are
// reported at once (language rule 1.3).

#include "script/compiler/compiler.hpp"

#include <algorithm>

#include "runtime/base/outside/file_bytes.hpp"
#include "script/compiler/application/application_loader.hpp"
#include "script/compiler/application/settings_reader.hpp"
#include "script/compiler/declaration_compiler.hpp"
#include "script/compiler/variable_use.hpp"
#include "script/xml/allowances.hpp"

namespace parlour::script {

namespace {

namespace fs = std::filesystem;

// All scripts of a folder, sorted by name.
std::vector<fs::path> scripts_in(const fs::path& folder) {
  auto scripts = list_files(folder, ".xml").value_or(std::vector<fs::path>());
  std::erase(scripts, folder / "settings.xml");
  return scripts;
}

// One compilation. The public functions are called once.
class Compiler {
public:
  Compiler(const fs::path& folder, const CompileOptions& options)
      : options_(options),
        loader_(folder, options.platform, findings_, options.texts) {}

  Compiled application(const fs::path& folder);
  Compiled file(const fs::path& path);

private:
  bool read_settings_file(const fs::path& path);
  void take_settings(Element root);
  Aliases aliases();
  void load_scripts();
  void load_all_scripts(const std::vector<fs::path>& scripts);
  void add_usual_plugins(Element& settings);
  void load_libraries();
  Compiled finish();

  const CompileOptions& options_;
  Findings findings_;
  ApplicationLoader loader_;
  std::shared_ptr<Program> program_ = std::make_shared<Program>();
  std::optional<Element> settings_;
};

// Other names of plug-ins that the platform knows.
Aliases Compiler::aliases() {
  const auto path = options_.platform / "aliases.xml";
  std::error_code ignored;
  if (options_.platform.empty() || !fs::exists(path, ignored))
    return {};
  const auto root = loader_.read(path, {"aliases"}, {});
  return root ? read_aliases(*root) : Aliases{};
}

void Compiler::take_settings(Element root) {
  program_->settings =
      read_settings(root, aliases(), options_.environment, findings_);
  if (options_.adjust)
    options_.adjust(program_->settings);
  settings_ = std::move(root);
}

// The scripts that the settings name, in that order.
void Compiler::load_scripts() {
  for (const auto& child : settings_->children)
    if (child.is("Scripts"))
      for (const auto& script : child.children)
        loader_.load_script(collapsed(script.text), script.position);
  if (program_->settings.scripts.empty())
    findings_.error(settings_->position, "<Scripts> names no script");
}

// All scripts in the order of their names; the first state begins.
void Compiler::load_all_scripts(const std::vector<fs::path>& scripts) {
  for (const auto& script : scripts) {
    program_->settings.scripts.push_back(script.filename().string());
    loader_.load_script(program_->settings.scripts.back(), {});
  }
  if (program_->settings.start.empty())
    program_->settings.start = loader_.first_state();
  if (scripts.empty())
    findings_.error(settings_->position,
                    "there is no script in this folder, and <settings> names "
                    "none; expected "
                    "<Scripts><Script>file.xml</Script></Scripts>");
}

// Settings without scripts and plug-ins only adjust a few things; the rest is
// the platform's (language rule 1.8).
void Compiler::add_usual_plugins(Element& settings) {
  if (settings.child("Scripts") || settings.child("Plugins") ||
      options_.platform.empty())
    return;
  auto usual =
      loader_.read(options_.platform / "settings.xml", {"settings"}, {});
  if (usual)
    for (auto& child : usual->children)
      settings.children.push_back(std::move(child));
}

// The phrases and repairs of the platform come after the application's own,
// which therefore take precedence.
void Compiler::load_libraries() {
  if (options_.platform.empty())
    return;
  auto libraries = options_.libraries;
  libraries.insert(libraries.end(), {"phrases-en", "repair"});
  for (const auto& library : libraries) {
    loader_.load_library(library, {});
    program_->settings.libraries.push_back(library);
  }
}

// Warnings are filtered after sorting, as sorting removes duplicates.
Compiled Compiler::finish() {
  auto documents = loader_.take_documents();
  compile_declarations(documents, {settings_ ? &*settings_ : nullptr}, loader_,
                       *program_, findings_);
  program_->files = findings_.files();
  findings_.sort();
  take_allowed(findings_);
  // Trees and findings are returned in any case: editors need them.
  if (findings_.has_errors())
    program_ = nullptr;
  else
    note_read_variables(*program_);
  return {std::move(program_), std::move(findings_), std::move(documents),
          std::move(settings_)};
}

// Without readable settings nothing else is known, so compiling ends there.
Compiled Compiler::application(const fs::path& folder) {
  auto root =
      loader_.read(settings_file(folder, options_.platform), {"settings"}, {});
  if (!root)
    return {nullptr, std::move(findings_)};
  add_usual_plugins(*root);
  take_settings(std::move(*root));
  program_->settings.folder = folder.string();
  if (settings_->child("Scripts"))
    load_scripts();
  else
    load_all_scripts(scripts_in(folder));
  load_libraries();
  return finish();
}

// The root tells what kind of file it is; a settings file can be checked alone.
Compiled Compiler::file(const fs::path& path) {
  program_->single_file = true;
  program_->settings.folder = path.parent_path().string();
  auto root = loader_.read(path, {"dialogue", "settings"}, {});
  if (!root)
    return {nullptr, std::move(findings_)};
  if (root->is("settings")) {
    take_settings(std::move(*root));
    return finish();
  }
  loader_.add(path, std::move(*root));
  return finish();
}

} // namespace

fs::path settings_file(const fs::path& folder, const fs::path& platform) {
  const bool brings_none =
      !is_there(folder / "settings.xml") && !scripts_in(folder).empty();
  return (brings_none ? platform : folder) / "settings.xml";
}

Compiled compile_application(const fs::path& folder,
                             const CompileOptions& options) {
  return Compiler(folder, options).application(folder);
}

Compiled compile_file(const fs::path& file, const CompileOptions& options) {
  auto folder = file.parent_path();
  return Compiler(folder.empty() ? "." : folder, options).file(file);
}

} // namespace parlour::script
