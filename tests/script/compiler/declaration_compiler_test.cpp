#include <gmock/gmock.h>

#include "script/compiler/declaration_compiler.hpp"
#include "tests/script/snippets.hpp"

namespace parlour::script {

using testing::ElementsAre;

struct WrongDeclaration {
  const char* text; // inside of <dialogue>, from column 11 on
  const char* finding;
};

class WrongDeclarations : public testing::TestWithParam<WrongDeclaration> {};

TEST_P(WrongDeclarations, are_told_exactly) {
  EXPECT_THAT(test::compile_declarations(GetParam().text).lines,
              ElementsAre(std::string("a.xml:1:") + GetParam().finding));
}

INSTANTIATE_TEST_SUITE_P(
    names, WrongDeclarations,
    testing::Values(
        WrongDeclaration{"<state name='s'/><state name='s'/>",
                         "28: error: there is a state 's' already, in line 1"},
        WrongDeclaration{"<topic name='t'/><topic name='t'/>",
                         "28: error: there is a topic 't' already, in line 1"},
        WrongDeclaration{
            "<handler name='h'/><handler name='h'/>",
            "30: error: there is a handler 'h' already, in line 1"},
        WrongDeclaration{
            "<var name='v'/><const name='v' expr='1'/>",
            "26: error: there is a variable 'v' already, in line 1"},
        WrongDeclaration{
            "<function name='f'/><function name='f'/>",
            "31: error: there is a function 'f' already, in line 1"},
        WrongDeclaration{
            "<function name='length'/>",
            "11: error: there is a built-in function 'length'; choose "
            "another name"},
        WrongDeclaration{"<function name='f'><param name='p'/><param name='p'/>"
                         "</function>",
                         "47: error: a second parameter named 'p'"},
        WrongDeclaration{"<function name='f'><param name='p' expr='1'/>"
                         "<param name='q'/></function>",
                         "56: error: parameters with a default come last"},
        WrongDeclaration{
            "<topic name='t'><slot name='s'/><slot name='s'/></topic>",
            "43: error: there is a slot 's' already, in line 1"},
        WrongDeclaration{"<facts name='f'/><facts name='f'/>",
                         "28: error: there are <facts> named 'f' already"},
        WrongDeclaration{"<grammar name='g'>#JSGF V1.0;</grammar>"
                         "<grammar name='g'>#JSGF V1.0;</grammar>",
                         "50: error: there is a grammar 'g' already"}));

INSTANTIATE_TEST_SUITE_P(
    references, WrongDeclarations,
    testing::Values(
        WrongDeclaration{"<topic name='Visit'/><topic name='t' needs='Vist'/>",
                         "55: error: there is no topic 'Vist', did you mean "
                         "'Visit'?"},
        WrongDeclaration{"<topic name='t' needs='t'/>",
                         "11: error: topic 't' needs itself, by its 'needs'"},
        WrongDeclaration{"<state name='s' grammar='g'/>",
                         "36: error: there is no grammar 'g'"},
        WrongDeclaration{"<grammar name='g'/>",
                         "11: error: <grammar> is empty; expected JSGF text or "
                         "'file'"},
        WrongDeclaration{"<grammar name='g' file='g.jsgf'/>",
                         "35: error: there is no file 'g.jsgf'"},
        WrongDeclaration{
            "<topic name='t'><slot name='Host'/><examples>"
            "<value>meet [Ho](Hots)</value></examples></topic>",
            "63: error: topic 't' has no slot 'Hots', did you mean "
            "'Host'?"},
        WrongDeclaration{"<phrases><phrase act='help' topic='x'>a</phrase>"
                         "</phrases>",
                         "46: error: there is no topic 'x'"},
        WrongDeclaration{
            "<phrases><phrase act='repromt'>a</phrase></phrases>",
            "33: warning: the engine says no act 'repromt', did you "
            "mean 'reprompt'?"}));

INSTANTIATE_TEST_SUITE_P(
    topics, WrongDeclarations,
    testing::Values(
        WrongDeclaration{
            "<topic name='t'><filled/><filled/></topic>",
            "36: error: a second <filled> in <topic>, after the one in line 1; "
            "put both into one, or take one out"},
        WrongDeclaration{
            "<topic name='t'><slot name='s'><cardinality type='set'/>"
            "</slot></topic>",
            "42: error: <cardinality type=\"set\"> needs at least one "
            "<value>"},
        WrongDeclaration{
            "<topic name='t'><slot name='s'><cardinality type='range'/>"
            "</slot></topic>",
            "42: error: <cardinality> needs the attribute 'from' or 'to'"},
        WrongDeclaration{
            "<topic name='t'><slot name='s'><cardinality "
            "type='pattern' pattern='('/></slot></topic>",
            "79: error: this is no regular expression: missing ): ("},
        WrongDeclaration{"<topic name='t'><slot name='s'><cardinality "
                         "type='query' source='db:name'/></slot></topic>",
                         "76: error: 'db:name' is not a column; expected "
                         "db:table.column"},
        WrongDeclaration{"<topic name='t' kind='enquiry'/>",
                         "11: warning: the enquiry 't' has no <query> and no "
                         "<filled>: nothing answers it"}));

INSTANTIATE_TEST_SUITE_P(
    knowledge, WrongDeclarations,
    testing::Values(
        WrongDeclaration{
            "<topic name='t'><query source='dbb' param='select 1'/>"
            "</topic>",
            "42: error: there is no knowledge of the kind 'dbb'; "
            "expected db, facts, aiml or ontology, did you mean 'db'?"},
        WrongDeclaration{
            "<topic name='t'><query source='aiml'/></topic>",
            "42: error: queries of the kind 'aiml' are not available "
            "yet"},
        WrongDeclaration{"<topic name='t'><query source='db'/></topic>",
                         "27: error: <query source=\"db\"> needs the attribute "
                         "'param': one select statement"},
        WrongDeclaration{
            "<topic name='t'><query source='db' param='drop table x'/>"
            "</topic>",
            "53: error: expected one select statement"},
        WrongDeclaration{"<topic name='t'><query source='facts:x'/></topic>",
                         "42: error: there are no <facts> named 'x'"},
        WrongDeclaration{
            "<topic name='t'><query source='db' param='select 1' "
            "order='1;'/></topic>",
            "70: error: '1;' is no order; expected columns such as "
            "\"level desc, name\""},
        WrongDeclaration{
            "<topic name='t'><slot name='Level'/><query source='db' "
            "param='select 1'><by slot='Levl'/></query></topic>",
            "93: error: topic 't' has no slot 'Levl', did you mean "
            "'Level'?"},
        WrongDeclaration{"<topic name='t'><slot name='L'/><query source='db' "
                         "param='select 1'><by slot='L' column='a b'/></query>"
                         "</topic>",
                         "100: error: 'a b' is not a column's name"}));

INSTANTIATE_TEST_SUITE_P(
    messages, WrongDeclarations,
    testing::Values(
        WrongDeclaration{
            "<handler name='h'><messages><component>"
            "<ASR><RecognitonResult/></ASR></component></messages>"
            "</handler>",
            "55: warning: ASR has no event 'RecognitonResult', did "
            "you mean 'RecognitionResult'?"},
        WrongDeclaration{
            "<handler name='h'><messages><component><ARS><Partial/>"
            "</ARS></component></messages></handler>",
            "50: warning: no component, role, agent or socket is called "
            "'ARS', did you mean 'ASR'?"},
        WrongDeclaration{
            "<handler name='h'><messages><on source='Robbot' "
            "event='*'/></messages></handler>",
            "51: warning: no component, role, agent or socket is called "
            "'Robbot', did you mean 'Robot'?"},
        WrongDeclaration{
            "<routes><filter source='ASR' command='*'/></routes>",
            "19: error: <filter> needs the attribute 'to' or 'drop'"},
        WrongDeclaration{
            "<routes><filter source='*' command='*' to='NLG' "
            "drop='true'/></routes>",
            "59: error: <filter> has both 'to' and drop=\"true\"; write "
            "either to, as, param, or drop"}));

} // namespace parlour::script
