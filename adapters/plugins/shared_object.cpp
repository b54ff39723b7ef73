#include "adapters/plugins/shared_object.hpp"

#include <cstring>
#include <fstream>
#include <optional>

#include <elf.h>
#include <link.h>

namespace parlour::adapters {

namespace {

using Header = ElfW(Ehdr);
using Segment = ElfW(Phdr);

// Reads a structure at an offset; nothing if the file is too short.
template <class Part>
std::optional<Part> part_at(std::ifstream& file, std::uint64_t offset) {
  Part part{};
  file.clear();
  file.seekg(static_cast<std::streamoff>(offset));
  if (!file.read(reinterpret_cast<char*>(&part), sizeof part))
    return {};
  return part;
}

// An ELF file with the word size of this program.
bool is_ours(const Header& header) {
  constexpr int bits = sizeof(void*) == 8 ? ELFCLASS64 : ELFCLASS32;
  return std::memcmp(header.e_ident, ELFMAG, SELFMAG) == 0 &&
         header.e_ident[EI_CLASS] == bits;
}

} // namespace

bool is_cut_off(const std::filesystem::path& path) {
  std::error_code code;
  const std::uint64_t size = std::filesystem::file_size(path, code);
  std::ifstream file(path, std::ios::binary);
  const auto header = part_at<Header>(file, 0);
  if (code || !header || !is_ours(*header))
    return false;
  // Every segment of the program header must lie within the file. The second
  // comparison cannot overflow because of the first.
  for (unsigned at = 0; at < header->e_phnum; ++at) {
    const auto segment = part_at<Segment>(
        file, header->e_phoff + std::uint64_t{at} * header->e_phentsize);
    if (!segment || segment->p_offset > size ||
        segment->p_filesz > size - segment->p_offset)
      return true;
  }
  return false;
}

} // namespace parlour::adapters
