#include "script/dialogue/saved/renaming_writer.hpp"
#include "tests/script/dialogue/saved/round_trip.hpp"

namespace parlour::dialogue {
namespace {

std::shared_ptr<const script::Program> program(const char* first,
                                               const char* second) {
  auto made = std::make_shared<script::Program>();
  made->pool = std::make_shared<script::ConstantPool>();
  made->topics.resize(2);
  made->topics[0].name = first;
  made->topics[1].name = second;
  return made;
}

struct Part {
  script::TopicId topic = script::no_id;
  std::string text;

  template <class Archive>
  void serialize(Archive& archive) {
    archive.topic(topic);
    archive(text);
  }
};

TEST(RenamingWriter, WritesTheIdsOfTheOtherProgram) {
  const auto to = program("Shops", "Taxi");
  const Renames renames(program("Taxi", "Shops"), to);
  RenamingWriter writer(renames);
  writer.write(Part{0, "said"});
  EXPECT_FALSE(writer.misses());
  const auto bytes = writer.take();
  Reader reader(to, bytes);
  Part part;
  reader(part);
  ASSERT_TRUE(reader.finish());
  EXPECT_EQ(part.topic, 1u);
  EXPECT_EQ(part.text, "said");
}

TEST(RenamingWriter, TellsWhatIsMissing) {
  const Renames renames(program("Taxi", "Shops"), program("Bus", "Shops"));
  RenamingWriter writer(renames);
  writer.write(Part{1, ""});
  writer.write(Part{script::no_id, ""});
  EXPECT_FALSE(writer.misses());
  writer.write(Part{0, ""});
  EXPECT_TRUE(writer.misses());
}

} // namespace
} // namespace parlour::dialogue
