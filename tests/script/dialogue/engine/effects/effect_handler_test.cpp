// What scripts ask for, whoever carries it out.
#include <gtest/gtest.h>

#include "script/dialogue/engine/effects/effect_handler.hpp"
#include "tests/script/dialogue/bell.hpp"

namespace parlour::dialogue {
namespace {

TEST(EffectHandler, AnErrorWithAHandlerOfItsOwn) {
  Bell world("<throw expr=\"'bad'\"/>", R"xml(
    <handler name="E"><messages><component><Script><Error>
      <speak param="Error: {_LPARAM1}"/><throw expr="'worse'"/>
    </Error></Script></component></messages></handler>)xml");
  world.ring();
  EXPECT_EQ(world.said(), Texts{"Error: bad"});
  EXPECT_EQ(world.seen(InspectionKind::error).size(), 2u);
}

TEST(EffectHandler, EndEndsTheSession) {
  Bell world("<speak param='Bye.'/><end/>",
             R"xml(<handler name="E"><messages><component><Session><Ended>
      <post module="Telephone" command="Over" param=""/></Ended></Session>
      </component></messages></handler>)xml");
  world.ring();
  EXPECT_EQ(world.said(), Texts{"Bye."});
  EXPECT_EQ(world.posted(), Texts{"Telephone.Over()"});
  EXPECT_TRUE(world.has_ended);
}

} // namespace
} // namespace parlour::dialogue
