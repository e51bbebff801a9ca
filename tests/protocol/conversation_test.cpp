// Requests and replies: every operation, every kind of error.
#include "verify/protocol/conversation.hpp"

#include <gtest/gtest.h>
#include <sys/resource.h>

#include <fstream>
#include <nlohmann/json.hpp>
#include <random>
#include <sstream>
#include <string>

#include "verify/protocol/answer.hpp"

namespace tps::protocol {
namespace {

using nlohmann::json;

json reply(const std::string& line) {
  return json::parse(reply_to(line).text);
}

json out(const std::string& op, const json& in) {
  const json answer = reply(json{{"seq", 5}, {"op", op}, {"in", in}}.dump());
  EXPECT_EQ(answer.at("seq"), 5);
  return answer.contains("out") ? answer["out"] : answer;
}

json timing(const json& u_B, const json& v_B, double L) {
  return {{"u_A", {0, 0}}, {"u_B", u_B}, {"v_A", {0, 0}}, {"v_B", v_B}, {"L", L}};
}

json pair() {
  return {{"u_A", {0, 0}}, {"u_B", {1, 0}}, {"v_A", {0, 0}}, {"v_B", {0, 1}}, {"m_A", 1}, {"m_B", "inf"}};
}

json with(json object, const json& more) {
  object.update(more);
  return object;
}

TEST(Conversation, HelloNamesWhatIsThere) {
  const json hello = reply(R"({"hello":1})");
  EXPECT_EQ(hello["name"], "tps");
  EXPECT_EQ(hello["ops"], json(operation_names()));
  EXPECT_TRUE(hello.contains("version"));
  EXPECT_TRUE(hello.contains("precision"));
  EXPECT_EQ(reply(R"({"hello":2})")["error"], "bad_request");
}

TEST(Conversation, ByeEnds) {
  const Reply bye = reply_to(R"({"bye":1})");
  EXPECT_TRUE(bye.last);
  EXPECT_EQ(bye.text, "");
}

TEST(Conversation, TimingQueriesAreCertified) {
  EXPECT_EQ(out("block_time", timing({5, 0}, {-1, 0}, 1)), (json{{"verdict", "hit"}, {"t", "0x1p+2"}}));
  EXPECT_EQ(out("block_time", timing({5, 0}, {1, 0}, 1)), (json{{"verdict", "receding"}, {"t", nullptr}}));
  // Grazing from afar: the literal discriminant is 0 for both.
  const double offset = 0x1p-30;
  EXPECT_EQ(out("block_time", timing({-1e4, 1 - offset}, {1, 0}, 1))["verdict"], "hit");
  EXPECT_EQ(out("block_time", timing({-1e4, 1 + offset}, {1, 0}, 1))["verdict"], "miss");
  EXPECT_EQ(out("tether_time", timing({1, 0}, {0, 1}, 1)), (json{{"verdict", "taut"}, {"t", "0x0p+0"}}));
  EXPECT_EQ(out("tether_time", timing({0, 0}, {"0x1p-1074", 0}, 1e300))["t"], "inf");
}

// The exact tie of the known results, and its neighbours.
TEST(Conversation, OrdersAreExact) {
  const auto order = [](const json& x) {
    return out("order", {{"first", with(timing({-10, 3}, {1, 0}, 5), {{"kind", "block"}})},
                         {"second", with(timing({x, 0}, {1, 0}, 5), {{"kind", "block"}})}})["order"];
  };
  EXPECT_EQ(order(-11), "equal");
  EXPECT_EQ(order(-11 - 0x1p-40), "before");
  EXPECT_EQ(order(-11 + 0x1p-40), "after");
  const json never = with(timing({1, 0}, {1, 0}, 5), {{"kind", "block"}});
  EXPECT_EQ(out("order", {{"first", never}, {"second", never}})["order"], "none");
}

TEST(Conversation, ResponsesHaveTheKeysOfTheirOperations) {
  EXPECT_EQ(
      out("apply_impulse", {{"m_A", 2}, {"m_B", "inf"}, {"v_A", {0, 0}}, {"v_B", {1, 0}}, {"dp", {1, 0}}}),
      (json{{"v_A", {"0x1p-1", "0x0p+0"}}, {"v_B", {"0x1p+0", "0x0p+0"}}}));
  EXPECT_EQ(out("collision_impulse", with(pair(), {{"c", 1}})), (json{{"dp", {"0x0p+0", "0x0p+0"}}}));
  EXPECT_EQ(out("revolution_impulse", with(pair(), {{"c_revolve", 0}, {"theta_revolve_deg", 45}})),
            (json{{"dp", {"0x0p+0", "0x1p+0"}}}));
  const json tether =
      out("tether_response", with(pair(), {{"c_retract", 1}, {"c_revolve", 0}, {"theta_revolve_deg", 45}}));
  EXPECT_EQ(tether, (json{{"kind", "revolve"},
                          {"dp", {"0x0p+0", "0x1p+0"}},
                          {"v_A", {"0x0p+0", "0x1p+0"}},
                          {"v_B", {"0x0p+0", "0x1p+0"}}}));
  EXPECT_EQ(out("load", {{"m_A", 1}, {"m_B", 3}, {"v_A", {4, 0}}, {"v_B", {0, 0}}}),
            (json{{"v_load", {"0x1p+0", "0x0p+0"}}}));
  EXPECT_EQ(
      out("restitution_impulse", {{"m_A", 1}, {"m_B", 1}, {"v_A", {0, 0}}, {"v_B", {2, 0}}, {"dp", {0, 0}}}),
      (json{{"dp_AB", {"-0x1p+0", "0x0p+0"}}}));
}

TEST(Conversation, BoundariesAreFlagged) {
  const json in =
      with(pair(), {{"v_B", {1, 1}}, {"c_retract", 1}, {"c_revolve", 1}, {"theta_revolve_deg", 45}});
  EXPECT_EQ(out("tether_response", in)["boundary"], true);
}

TEST(Conversation, GroupsLoadAndRestitute) {
  const json bodies = {{{"m", 1}, {"u", {0, 0}}, {"v", {1, 0}}}, {{"m", 1}, {"u", {1, 0}}, {"v", {0, 0}}}};
  const json collision = {{"i", 0}, {"j", 1}, {"limit", "inner"}, {"c", 1}};
  EXPECT_EQ(out("group", {{"bodies", bodies}, {"collisions", {collision}}}),
            json::parse(R"({"loaded":[["0x1p-1","0x0p+0"],["0x1p-1","0x0p+0"]],
                            "restituted":[["0x0p+0","0x0p+0"],["0x1p+0","0x0p+0"]]})"));
  EXPECT_EQ(out("group", {{"bodies", json::array()}, {"collisions", json::array()}}),
            json::parse(R"({"loaded":[],"restituted":[]})"));
}

TEST(Conversation, TheNextEventOfAScene) {
  std::ifstream file(TPS_SOURCE_DIR "/data/scenes/three-body.json");
  json scene = json::parse(file);
  json event = out("next_event", {{"scene", scene}});
  EXPECT_EQ(event["kind"], "rebound");
  EXPECT_EQ(event["i"], 0);
  EXPECT_EQ(event["j"], 1);
  EXPECT_EQ(event["dt"], "0x1p+0");
  EXPECT_EQ(event["state"].size(), 3);
  EXPECT_EQ(event["state"][2]["velocity"], (json{"0x0p+0", "0x0p+0"}));
  for (json& particle : scene["particles"]) particle["velocity"] = {0, 0};
  event = out("next_event", {{"scene", scene}});
  EXPECT_EQ(event["kind"], "none");
  EXPECT_FALSE(event.contains("dt"));
  EXPECT_FALSE(event.contains("i"));
}

TEST(Conversation, TheRunOfAScene) {
  std::ifstream file(TPS_SOURCE_DIR "/data/scenes/three-body.json");
  json scene = json::parse(file);
  const json all = out("simulate", {{"scene", scene}})["trace"];
  EXPECT_EQ(all.front()["trace"], 1);
  EXPECT_EQ(all.front()["options"]["timing"], "certified");
  EXPECT_EQ(all.back()["end"], "no_more_events");
  const json first = out("simulate", {{"scene", scene}, {"max_events", 1}})["trace"];
  EXPECT_EQ(first.back()["end"], "max_events");
  EXPECT_EQ(first.back()["events"], 1);
  EXPECT_LT(first.size(), all.size());
  for (const json& wrong : {json(0), json(1001), json(1.5), json("2")}) {
    const json answer = out("simulate", {{"scene", scene}, {"max_events", wrong}});
    EXPECT_NE(answer["message"].get<std::string>().find("/in/max_events"), std::string::npos) << answer;
  }
  scene["observe"]["clusters"]["species"] = "X";
  const json answer = out("simulate", {{"scene", scene}});
  EXPECT_NE(answer["message"].get<std::string>().find("/in/scene/observe"), std::string::npos) << answer;
}

struct Refused {
  const char* line;
  const char* kind;
  const char* says;
};

TEST(Conversation, SaysWhatIsWrong) {
  const Refused cases[] = {
      {"", "bad_json", "empty"},
      {"{", "bad_json", "not JSON"},
      {"\xff", "bad_json", "not"},
      {"{\"hello\":1} x", "bad_json", "not JSON"},
      {R"({"seq":1,"seq":2,"op":"load","in":{}})", "bad_json", "stands twice"},
      {R"({"seq":1,"op":"load","in":{"m_A":NaN}})", "bad_json", "NaN"},
      {"[]", "bad_request", "a request is an object"},
      {"3", "bad_request", "a request is an object"},
      {"null", "bad_request", "a request is an object"},
      {R"({"hello":1,"bye":1})", "bad_request", "hello stands alone"},
      {R"({"hello":1,"x":2})", "bad_request", "hello stands alone"},
      {R"({"seq":1,"op":"load","in":{"m_A":1,"m_B":1,"v_A":["0x1.00000000000001p+0",0],"v_B":[0,0]}})",
       "bad_input", R"(/in/v_A: component 0 is "0x1.00000000000001p+0", a number that no double has)"},
      {R"({"seq":1,"op":"load","in":{"m_A":"1","m_B":1,"v_A":[0,0],"v_B":[0,0]}})", "bad_input",
       R"(/in/m_A: is "1", which is no hexadecimal float)"},
      {R"({"op":"load","in":{}})", "bad_request", "seq"},
      {R"({"seq":"1","op":"load","in":{}})", "bad_request", "seq"},
      {R"({"seq":1.5,"op":"load","in":{}})", "bad_request", "seq"},
      {R"({"seq":1e300,"op":"load","in":{}})", "bad_request", "seq"},
      {R"({"seq":1,"op":1,"in":{}})", "bad_request", "op must be"},
      {R"({"seq":1,"op":"load"})", "bad_request", "in, the input"},
      {R"({"seq":1,"op":"load","in":{},"opp":0})", "bad_request", "did you mean op"},
      {R"({"seq":1,"op":"load","in":[]})", "bad_input", "must be an object"},
      {R"({"seq":1,"op":"load","in":{"m_A":{},"m_B":1,"v_A":[1,0],"v_B":[0,0]}})", "bad_input", "/in/m_A"},
      {R"({"seq":1,"op":"load","in":{"m_A":1,"mB":1,"v_A":[1,0],"v_B":[0,0]}})", "bad_input",
       "did you mean m_B"},
      {R"({"seq":1,"op":"block_time","in":{"u_A":[0,0],"u_B":[1,0],"v_A":[0,0],"v_B":[0,1],"L":0}})",
       "bad_input", "above 0"},
      {R"({"seq":1,"op":"order","in":{"first":{"kind":"block"}}})", "bad_input", "/in/first"},
      {R"({"seq":1,"op":"order","in":{"first":{"kind":"bock"},"second":1}})", "bad_input",
       "\"block\" or \"tether\""},
      {R"({"seq":1,"op":"group","in":{"bodies":{},"collisions":[]}})", "bad_input", "must be a list"},
      {R"({"seq":1,"op":"group","in":{"bodies":[],"collisions":[],"more":1}})", "bad_input", "no key more"},
      {R"({"seq":1,"op":"group","in":{"bodies":[{"m":1,"u":[0,0],"v":[0,0]},{"m":1,"u":[0,0,0],"v":[0,0,0]}],"collisions":[]}})",
       "bad_input", "/in/bodies/1: has another dimension"},
      {R"({"seq":1,"op":"group","in":{"bodies":[{"m":1,"u":[0,0],"v":[0,0]}],"collisions":[{"i":0,"j":1,"limit":"inner","c":1}]}})",
       "bad_input", "/in/collisions/0/j: is 1; it must be a place in bodies, 0 to 0"},
      {R"({"seq":1,"op":"group","in":{"bodies":[{"m":1,"u":[0,0],"v":[0,0]}],"collisions":[{"i":0,"j":0,"limit":"inner","c":1}]}})",
       "bad_input", "/in/collisions/0: bodies 0 and 0 are in one group"},
      {R"({"seq":1,"op":"next_event","in":{"scene":{"tps":1}}})", "bad_input", "/in/scene"},
      {R"({"seq":1,"op":"next_event","in":{}})", "bad_input", "scene"},
      {R"({"seq":1,"op":"simulate","in":{"scene":{"tps":1}}})", "bad_input", "/in/scene"},
  };
  for (const Refused& refused : cases) {
    const json answer = reply(refused.line);
    EXPECT_EQ(answer.value("error", ""), refused.kind) << refused.line << "\n" << answer;
    EXPECT_NE(answer.value("message", "").find(refused.says), std::string::npos) << refused.line << "\n"
                                                                                 << answer;
    if (std::string(refused.kind) == "bad_input") {
      EXPECT_EQ(answer["seq"], 1) << refused.line;
    }
  }
}

TEST(Conversation, AnUnknownOperationIsSkipped) {
  const json answer = reply(R"({"seq":-7,"op":"warp","in":{}})");
  EXPECT_EQ(answer["seq"], -7);
  EXPECT_EQ(answer["skip"], "unknown_op");
}

TEST(Conversation, TooManyBodiesAreRefused) {
  json bodies = json::array();
  for (int n = 0; n < 33; ++n) bodies.push_back({{"m", 1}, {"u", {n, 0}}, {"v", {0, 0}}});
  EXPECT_EQ(out("group", {{"bodies", bodies}, {"collisions", json::array()}})["error"], "bad_input");
}

// Requests with bytes changed, cut and repeated: always one line of JSON.
TEST(Conversation, GarbageNeverBreaksIt) {
  const std::string request =
      R"({"seq":1,"op":"tether_response","in":{"u_A":[0,0],"u_B":["0x1p+0",0],"v_A":[0,0],"v_B":[0,1],"m_A":1,"m_B":"inf","c_retract":1,"c_revolve":0,"theta_revolve_deg":45}})";
  std::mt19937 random(7);
  const auto below = [&](std::size_t n) {
    return std::uniform_int_distribution<std::size_t>(0, n - 1)(random);
  };
  int errors = 0;
  for (int n = 0; n < 2000; ++n) {
    std::string text = request;
    for (std::size_t changes = below(4); changes > 0; --changes)
      text[below(text.size())] = static_cast<char>(below(256));
    if (below(4) == 0) text.resize(below(text.size()));
    if (below(4) == 0) text.insert(below(text.size() + 1), text.substr(0, below(text.size() + 1)));
    const Reply answer = reply_to(text);
    EXPECT_EQ(answer.text.find('\n'), std::string::npos);
    errors += json::parse(answer.text).contains("error") ? 1 : 0;
  }
  EXPECT_GT(errors, 500);
  EXPECT_LT(errors, 2000);
}

// What fails behind the reading of a request is told with its seq: here the system has no file for a trace.
TEST(Conversation, AnErrorOfOursKeepsTheSeq) {
#ifdef __SANITIZE_ADDRESS__
  GTEST_SKIP() << "the sanitizer asks through a pipe whether an address can be read, and takes one for bad "
                  "that it cannot ask about";
#endif
  const json scene =
      json::parse(R"({"tps":1,"dimension":2,"duration":1,"species":{"a":{"mass":1,"radius":1}},)"
                  R"("particles":[{"species":"a","position":[0,0]}]})");
  struct rlimit before {};
  ASSERT_EQ(getrlimit(RLIMIT_NOFILE, &before), 0);
  const struct rlimit none { 0, before.rlim_max };
  ASSERT_EQ(setrlimit(RLIMIT_NOFILE, &none), 0);
  const std::string text =
      reply_to(json{{"seq", 41}, {"op", "simulate"}, {"in", {{"scene", scene}}}}.dump()).text;
  ASSERT_EQ(setrlimit(RLIMIT_NOFILE, &before), 0);
  const json answer = json::parse(text);
  EXPECT_EQ(answer.at("seq"), 41);
  EXPECT_EQ(answer.at("error"), "internal") << text;
}

}  // namespace
}  // namespace tps::protocol
