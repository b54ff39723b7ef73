// Passes that look at values: conditions, fields, arguments, lists.
#include "tests/script/lint/lint_case.hpp"

namespace parlour::script::lint {

INSTANTIATE_TEST_SUITE_P(
    places, LintCase,
    testing::Values(
        Linted{"<function name='main'><if cond=\"find('abc', 'a')\"/>"
               "<if cond=\"not indexof([1], 1)\"/></function>",
               "3:33 always-true, 3:62 always-true"},
        Linted{"<function name='main'><if cond=\"find('abc', 'a') ge 0\"/>"
               "<if cond='true or false'/></function>",
               ""},
        Linted{"<function name='main'><var name='x' expr=\"date() or 'b'\"/>"
               "<print param='{x}'/></function>",
               ""}));

INSTANTIATE_TEST_SUITE_P(
    blocks, LintCase,
    testing::Values(
        Linted{"<function name='main'><return/><print param='x'/></function>",
               "3:32 unreachable-statement"},
        Linted{"<function name='main'><for name='i' from='1' to='2'><if "
               "cond='i == 1'><continue/><else/><break/></if><print "
               "param='x'/></for></function>",
               ""},
        Linted{"<function name='main'><try><throw expr='1'/><catch/></try>"
               "<print param='x'/></function>",
               ""},
        Linted{"<function name='main'><transit state='Welcome'/><print "
               "param='x'/><transit state='Welcome'/></function>",
               "3:23 lost-transit"},
        Linted{"<function name='main'><if cond='1 == 1'><transit "
               "state='Welcome'/><else/><transit state='Welcome'/></if>"
               "</function>",
               ""}));

INSTANTIATE_TEST_SUITE_P(
    cases, LintCase,
    testing::Values(
        Linted{"<function name='main'><switch expr='1'><case value='1'/><case "
               "value='2'><print param='x'/></case></switch></function>",
               "3:40 case-without-effect"},
        Linted{"<function name='main'><switch expr='1'><case value='1, 2'>"
               "<print param='x'/></case></switch></function>",
               "3:53 case-without-effect"},
        Linted{"<function name='main'><switch expr='1'><case value=\"'a' or "
               "'b'\"><print param='x'/></case></switch></function>",
               "3:53 case-without-effect"},
        Linted{"<function name='main'><switch expr='1'><case value='yes, "
               "please'><print param='x'/></case><case value='1'/><default>"
               "<print param='x'/></default></switch></function>",
               ""}));

INSTANTIATE_TEST_SUITE_P(
    slots_of_habit, LintCase,
    testing::Values(
        Linted{"<topic name='T'><slot name='A' question='?'/></topic>", ""},
        Linted{"<topic name='T'><slot name='A' question='?'/><filled><ask "
               "slot='A'/></filled></topic>",
               ""},
        Linted{"<topic name='T'><slot name='A' type='Functional' question='?'>"
               "<cardinality type='set'><value>a, b</value></cardinality>"
               "</slot></topic>",
               "3:87 joined-values"},
        Linted{"<topic name='T'><slot name='A' type='Functional' question='?'>"
               "<cardinality type='set'><value>a, b</value><value>c</value>"
               "</cardinality></slot></topic>",
               ""}));

INSTANTIATE_TEST_SUITE_P(
    said_and_subscribed, LintCase,
    testing::Values(
        Linted{"<function name='main'><say act='greeet'/></function>",
               "3:33 unknown-act"},
        Linted{"<function name='main'><say act='greet'/><say act='own'/>"
               "</function><phrases><phrase act='own'>x</phrase></phrases>",
               ""},
        Linted{"<function name='main'><subscribe source='ASRR'/><subscribe "
               "source='ASR' command='Partal'/><unsubscribe source='*'/>"
               "</function>",
               "3:42 unknown-module, 3:82 unknown-event"}));

INSTANTIATE_TEST_SUITE_P(
    functions, LintCase,
    testing::Values(Linted{"<function name='f'/>", "3:1 unused-function"},
                    Linted{"<function name='f'><call function='f'/></function>",
                           "3:1 unused-function"},
                    Linted{"<function name='f'/><function name='main'><call "
                           "function='f'/></function>",
                           ""},
                    Linted{"<function name='f'/><function name='main'><print "
                           "param='{f()}'/></function>",
                           ""},
                    Linted{"<function name='f'/><function name='main'><call "
                           "function='{_LPARAM1}'/></function>",
                           ""},
                    Linted{"<function name='f'/><phrases><phrase "
                           "act='help'>{f()}</phrase></phrases>",
                           ""}));

INSTANTIATE_TEST_SUITE_P(
    variables, LintCase,
    testing::Values(
        Linted{"<var name='v' expr='1'/>", "3:12 unread-variable"},
        Linted{"<var name='v' expr='1'/><function name='main'><set name='v' "
               "expr='2'/></function>",
               "3:12 unread-variable"},
        Linted{"<const name='v' expr='1'/><phrases><phrase "
               "act='help'>{v}</phrase></phrases>",
               ""},
        Linted{"<function name='main'><var name='v' expr='1'/></function>",
               "3:34 unread-variable"},
        Linted{"<function name='main'><object name='v' class='list'/><append "
               "name='v' expr='1'/><print param='{v}'/></function>",
               ""},
        Linted{"<function name='main'><querydb param='select 1' "
               "return='r'/></function>",
               ""},
        Linted{"<function name='main'><var name='v' expr='1'/><call "
               "function='append'><var expr='v'/><var "
               "expr='1'/></call></function>",
               ""}));

INSTANTIATE_TEST_SUITE_P(
    messages, LintCase,
    testing::Values(
        Linted{"<function name='main'><post module='ARS' "
               "command='Finish'/></function>",
               "3:37 unknown-module"},
        Linted{"<function name='main'><post module='ASR' "
               "command='Finsh'/></function>",
               "3:51 unknown-command"},
        Linted{"<function name='main'><post module='{_LPARAM1}' "
               "command='x'/><post module='Record' "
               "command='start_mic'/></function>",
               ""},
        Linted{"<function name='main'><load plugin='P' "
               "name='AST'/><post module='AST' command='x'/>"
               "</function><handler name='H'><messages><component><AST>"
               "<Said><log param='x'/></Said></AST></component></messages>"
               "</handler>",
               ""},
        Linted{"<function name='main'><send agent='Porter' "
               "command='Wave'/></function>",
               ""},
        Linted{"<function name='main'><send agent='Robot' command='Stop'/>"
               "<send agent='Proter' command='Goto'/></function>",
               "3:36 unknown-module, 3:72 unknown-module"},
        Linted{"<routes><relay source='ASR' command='*' "
               "to='NLU, Spekaer'/></routes>",
               "3:45 unknown-module"}));

INSTANTIATE_TEST_SUITE_P(
    slots, LintCase,
    testing::Values(
        Linted{"<topic name='T'><slot name='S'/></topic>",
               "3:17 unfillable-slot"},
        Linted{"<topic name='T'><slot name='S' type='Functional' "
               "question='Which?'/></topic>",
               ""},
        Linted{"<topic name='T'><slot name='S'/><examples><value>a "
               "[b](S)</value></examples></topic>",
               ""},
        Linted{"<topic name='T'><slot name='S'/><started><set "
               "name='this.S' expr='1'/></started></topic>",
               ""},
        Linted{"<topic name='T'><slot name='S'><cardinality type='range' "
               "from='3' to='1'/></slot></topic>",
               "3:32 unfillable-slot"}));

INSTANTIATE_TEST_SUITE_P(
    time, LintCase,
    testing::Values(
        Linted{"<function name='main'><timer name='t' after='2m' "
               "keeps-open='false'/></function>",
               ""},
        Linted{"<function name='main'><timer name='t' after='2m' "
               "repeat='true'/></function>",
               "3:23 lost-timer"},
        Linted{"<function name='main'><timer name='t' after='2m' "
               "repeat='true' keeps-open='true'/><timer name='u' after='2m'/>"
               "<timer name='v' after='59s' repeat='true'/></function>",
               ""},
        Linted{"<handler name='h'><messages><on source='*' event='*'><transit "
               "state='B'/></on></messages></handler><state name='B'>"
               "<Entrance><if cond='1 lt 2'><timer name='t' after='1s'/>"
               "<transit state='Welcome'/></if></Entrance></state>",
               "3:144 lost-timer"},
        Linted{"<handler name='h'><messages><on source='*' event='*'><transit "
               "state='B'/><timer name='t' after='1s'/><push state='B'/></on>"
               "</messages></handler><state name='B'><Entrance><timer name='t' "
               "after='1s' ends-with='session'/><pop/></Entrance></state>",
               ""}));

INSTANTIATE_TEST_SUITE_P(
    loops, LintCase,
    testing::Values(
        Linted{"<function name='main'><while cond='true'/></function>",
               "3:36 endless-loop"},
        Linted{"<function name='main'><while "
               "cond='true'><break/></while></function>",
               ""},
        Linted{"<function name='main'><var name='i' expr='1'/><while cond='i "
               "lt 3'><print param='x'/></while></function>",
               "3:60 endless-loop"},
        Linted{"<function name='main'><var name='i' expr='1'/><while cond='i "
               "lt 3'><set name='i' expr='i + 1'/></while></function>",
               ""},
        Linted{"<function name='main'><while cond='false'/></function>",
               "3:36 empty-loop"},
        Linted{"<function name='main'><for name='i' from='3' "
               "to='1'/></function>",
               "3:23 empty-loop"},
        Linted{"<function name='main'><for name='i' from='3' to='1' "
               "step='-1'/></function>",
               ""}));

INSTANTIATE_TEST_SUITE_P(
    texts, LintCase,
    testing::Values(
        Linted{"<function name='main'><param name='who'/><print param='Hello "
               "{who'/></function>",
               "3:62 text-like-expression"},
        Linted{"<function name='main'><param name='who'/><print param='Hello "
               "{{who}}'/></function>",
               "3:62 text-like-expression"},
        Linted{"<function name='main'><param name='who'/><print param='Hello "
               "{who} {so on} {{it}}'/></function>",
               ""},
        // A name in it, or the look of an expression; words are words.
        Linted{"<function name='main'><param name='who'/>\n"
               "<print param='{typeof who} {the who} {(who}'/>\n"
               "<print param='{1 = 2} {=== so ===} {so, on; and on}'/>"
               "</function>",
               "4:15 text-like-expression, 4:38 text-like-expression, "
               "5:15 text-like-expression"},
        Linted{"<topic name='T'><slot question='So {on' name='S' "
               "type='Functional'><explain><value>Because {of "
               "it.</value><value>{1 + 1} {{ok}}</value>"
               "</explain></slot><completed><speak param='so {{on}} }'/>"
               "</completed></topic>",
               "3:36 text-like-expression, 3:92 text-like-expression, "
               "3:188 text-like-expression"}));

INSTANTIATE_TEST_SUITE_P(
    computing, LintCase,
    testing::Values(
        Linted{"<function name='read'><readfile name='a' return='t'/><return "
               "expr='t'/></function><var name='x' expr='read()'/><function "
               "name='main'><print param='{x}'/></function>",
               "3:103 querying-text"},
        Linted{"<function name='shops'><querydb param='select 1' return='r'/>"
               "<return expr='r'/></function>"
               "<function name='said'><return expr='list(shops())'/></function>"
               "\n<phrases><phrase act='greet'>{said()}</phrase></phrases>",
               "4:10 querying-text"},
        Linted{"<function name='shops'><querydb param='select 1' return='r'/>"
               "<return expr='r'/></function>\n<topic name='T'>"
               "<slot name='S' type='Functional' question='Which?'>"
               "<explain><value>{shops()}"
               "</value></explain></slot>"
               "<filled><speak param='{shops()}'/></filled></topic>",
               "4:17 querying-text"},
        Linted{"<function name='f'><param name='x'/>"
               "<return expr='x gt 0 ? f(x - 1) : 0'/></function>"
               "<phrases><phrase act='greet'>{f(3)}</phrase></phrases>",
               ""}));

INSTANTIATE_TEST_SUITE_P(
    sql, LintCase,
    testing::Values(
        Linted{"<function name='main'><param name='x'/><var name='q' "
               "expr=\"'select * from t where a=' + x\"/><querydb param='q' "
               "return='r'/><print param='r'/></function>",
               "3:60 joined-sql"},
        Linted{"<function name='main'><param name='x'/><querydb param='select "
               "* from t where a={x}' return='r'/><print "
               "param='r'/></function>",
               ""}));

INSTANTIATE_TEST_SUITE_P(
    conditions, LintCase,
    testing::Values(
        Linted{"<function name='main'><var name='x' expr='1'/>\n"
               "<if cond='x == 1 or 2'/><if cond='x == 1 or x == 2'/>\n"
               "<if cond='x and not 2'/><if cond='not x or true'/>\n"
               "<print param=\"{x or 'none'} {x == 1 or 'none'}\"/>\n"
               "<print param=\"{'a' ? x : 2}\"/></function>",
               "4:21 constant-condition, 5:21 constant-condition, "
               "6:40 constant-condition, 7:16 constant-condition"},
        Linted{"<function name='main'><while cond='1'/></function>",
               "3:36 endless-loop"}));

INSTANTIATE_TEST_SUITE_P(
    fields, LintCase,
    testing::Values(
        Linted{"<function name='main'><querydb param='select 1' return='r'/>\n"
               "<print param='{r.rows[0].a} {r.count} {r.columns}'/>\n"
               "<print param='{r.row} {r.length}'/></function>",
               "5:18 unknown-field, 5:26 unknown-field"},
        Linted{"<function name='main'><var name='l' expr='[1]'/>\n"
               "<print param='{l.length} {length(l)}'/></function>",
               "4:18 unknown-field"},
        // What is also written otherwise may be anything.
        Linted{"<function name='main'><var name='l' expr='[1]'/>\n"
               "<set name='l' expr=\"{'length': 1}\"/>\n"
               "<print param='{l.length}'/></function>",
               ""},
        Linted{"<function name='main'><try><throw expr='1'/>\n"
               "<catch name='e'><print param='{e.message} {e.text}'/></catch>"
               "</try></function>",
               "4:46 unknown-field"}));

INSTANTIATE_TEST_SUITE_P(
    arguments, LintCase,
    testing::Values(Linted{
        "<function name='main'>\n"
        "<print param=\"{format('{0}', 1)} {format('{} {{0}}', 1)}\"/>\n"
        "<print param=\"{date('yyyy')} {date('%Y')} {time()}\"/>\n"
        "<print param=\"{format('{:05}', 1)}\"/>\n"
        "<print param=\"{sort([1], 'down')} {matches('a', '(')}\"/>\n"
        "<print param=\"{type(1) == 'int'} {type(1) == 'integer'}\"/>\n"
        "<object name='a' class='array' size='-1'/><print param='{a}'/>"
        "</function>",
        "4:16 odd-argument, 5:16 odd-argument, "
        "7:16 odd-argument, 7:36 odd-argument, 8:24 odd-argument, "
        "9:38 odd-argument"}));

INSTANTIATE_TEST_SUITE_P(
    lists, LintCase,
    testing::Values(Linted{
        "<function name='main'><var name='x' expr='[1]'/>\n"
        "<print param='[x]'/><print param='[x, 1]'/>\n"
        "<speak param='[x, 1]'/><speak param='[laughs]'/>\n"
        "<for each='y' in='[x]'><print param='{y}'/></for>\n"
        "<post module='Taxi' command='Book' param='[1, 2]'/>\n"
        "<post module='Taxi' command='Book' param='[x, 2]'/></function>",
        "4:15 list-as-text, 5:15 list-as-text, 6:19 list-as-text, "
        "7:43 text-like-expression"}));

INSTANTIATE_TEST_SUITE_P(
    events, LintCase,
    testing::Values(
        Linted{"<handler name='H'><messages><component><Script>\n"
               "<raised/>\n<Error/>\n<Nobody/></Script></component></messages>"
               "</handler>"
               "<handler name='G'><messages><component><Session><Started>"
               "<fire event='Raised'/></Started></Session></component>"
               "</messages></handler>",
               "6:1 unknown-event"},
        Linted{"<handler name='G'><messages><component><Session><Started>\n"
               "<fire event='Raised'/><fire event='{_STATE}'/></Started>"
               "</Session></component></messages></handler>",
               "4:14 unhandled-event"},
        Linted{"<handler name='H'><messages><on source='*' event='Raised'/>"
               "</messages></handler>"
               "<handler name='G'><messages><component><Session><Started>"
               "<fire event='Raised'/></Started></Session></component>"
               "</messages></handler>",
               ""}));

INSTANTIATE_TEST_SUITE_P(
    foreign_texts, LintCase,
    testing::Values(Linted{
        "<function name='main'><var name='x' expr='1'/>\n"
        "<print param='${x} $x %x% #{x}'/>\n"
        "<print param='5$ 7% #x a$x $y {x}% {% if %}'/>\n"
        "<print param='{x|upper} {length(x}'/>\n"
        "<print param='{{x}}'/></function>",
        "4:15 text-like-expression, 4:20 text-like-expression, "
        "4:23 text-like-expression, 4:27 text-like-expression, "
        "5:36 text-like-expression, 6:15 text-like-expression, "
        "6:25 text-like-expression, 7:15 text-like-expression"}));

} // namespace parlour::script::lint
