// What takes the place of sphinx_decoder.cpp where the library is missing.
#include "adapters/asr/sphinx/sphinx_decoder.hpp"

namespace parlour::adapters::asr {

struct SphinxDecoder::Implementation {};

Expected<void> SphinxDecoder::is_built_in() {
  return fail(ErrorKind::settings,
              "this program was built without PocketSphinx; install "
              "libpocketsphinx-dev and pocketsphinx-en-us and build it again, "
              "or use another component for the role ASR");
}

SphinxDecoder::SphinxDecoder(std::unique_ptr<Implementation> implementation)
    : implementation_(std::move(implementation)) {}

SphinxDecoder::SphinxDecoder(SphinxDecoder&&) noexcept = default;
SphinxDecoder& SphinxDecoder::operator=(SphinxDecoder&&) noexcept = default;
SphinxDecoder::~SphinxDecoder() = default;

Expected<SphinxDecoder> SphinxDecoder::make(const std::string&,
                                            const std::string&, Passes) {
  return tl::make_unexpected(is_built_in().error());
}

Expected<void> SphinxDecoder::add_grammar(const std::string&,
                                          const std::string&) {
  return is_built_in();
}

Expected<void> SphinxDecoder::add_domain(const std::string&,
                                         const std::string&) {
  return is_built_in();
}

Expected<void> SphinxDecoder::add_keywords(const std::string&,
                                           const std::string&) {
  return is_built_in();
}

Expected<void> SphinxDecoder::begin(const std::string&) {
  return is_built_in();
}

void SphinxDecoder::hear(std::span<const Sample>) {}

std::string SphinxDecoder::text() const {
  return {};
}

std::vector<SpottedPhrase> SphinxDecoder::spotted() const {
  return {};
}

std::vector<HeardWord> SphinxDecoder::finish() {
  return {};
}

void SphinxDecoder::drop() {}

} // namespace parlour::adapters::asr
