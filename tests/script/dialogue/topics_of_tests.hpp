// Topics that several tests use.
#pragma once

#include "tests/script/dialogue/conversation_world.hpp"

namespace parlour::dialogue {

inline WorldOptions starting_with(const char* topic) {
  WorldOptions options;
  options.start = topic;
  return options;
}

// A task of three slots that says what happens to it.
inline constexpr const char* booking = R"xml(
  <topic name="Booking">
    <slot name="Place" type="Functional" question="Where?">
      <cardinality type="set"><value>Hall</value><value>Garden</value>
      </cardinality>
      <help><value>Which place?</value></help>
      <explain><value>I need a place.</value></explain>
      <filled><speak param="Place {this.Place}."/></filled>
    </slot>
    <slot name="Time" type="Functional" question="When?">
      <cardinality type="time"/>
      <filled><speak param="Time {this.Time}."/></filled>
    </slot>
    <slot name="Name" confirm="never"/>
    <started><speak param="Started."/></started>
    <suspended><speak param="Suspended."/></suspended>
    <resumed><speak param="Resumed."/></resumed>
    <filled><speak param="Filled."/></filled>
    <completed><speak param="Completed."/></completed>
    <cancelled><speak param="Cancelled."/></cancelled>
  </topic>
  <topic name="Taxi">
    <slot name="Street" type="Functional" question="Which street?"/>
    <completed><speak param="Taxi comes."/></completed>
  </topic>
  <topic name="Weather" initiative="user">
    <slot name="Day" type="Functional"/>
    <completed><speak param="Sunny."/></completed>
  </topic>)xml";

// A task whose host is always confirmed, and whose times depend on each other.
inline constexpr const char* meeting = R"xml(
  <topic name="Meeting">
    <slot name="Host" type="Functional" question="Whom?" confirm="explicit">
      <cardinality type="set"><value>Ann Lee</value><value>Bob Lee</value>
      </cardinality>
      <filled><speak param="Host {this.Host}."/></filled>
    </slot>
    <slot name="Start" type="Functional" question="From?" confirm="never"/>
    <slot name="End" type="Functional" question="To?" confirm="never"/>
    <constraint cond="this.End gt this.Start" message="It must end later."/>
    <rule if="this.Start == 9 and not this.End"><set name="this.End" expr="10"/>
    </rule>
  </topic>)xml";

// A task whose slot asks for a yes, and one whose slot is always confirmed.
inline constexpr const char* transfer = R"xml(
  <topic name="Transfer">
    <slot name="Host" type="Functional" question="Whom?">
      <filled><try><confirm question="Call {this.Host}?">
        <yes><speak param="Calling."/></yes>
        <no><speak param="Not calling."/><clear slot="Host"/></no></confirm>
        <catch name="e"><speak param="{e.kind}."/></catch></try></filled>
    </slot>
    <slot name="Reason" type="Functional" question="Why?"/>
  </topic>
  <topic name="Hours"><slot name="Day" type="Functional" question="Which day?"
    confirm="explicit"/><completed><speak param="Nine."/></completed></topic>
  )xml";

} // namespace parlour::dialogue
