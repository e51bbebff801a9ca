// Eqs. (3), (4), (6), (7) over a pipe: c++ -std=c++20 -O2 adapter.cpp -o adapter; tps conform -- ./adapter
#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <iostream>
#include <map>
#include <nlohmann/json.hpp>
#include <string>
#include <valarray>
#include <vector>

using Json = nlohmann::json;
using Vec = std::valarray<double>;

/// Numbers come as hexadecimal floats in strings, "inf" among them.
double number(const Json& x) {
  return x.is_string() ? std::strtod(x.get_ref<const std::string&>().c_str(), nullptr) : x.get<double>();
}

Vec vec(const Json& list) {
  Vec x(list.size());
  std::transform(list.begin(), list.end(), std::begin(x), number);
  return x;
}

/// As JSON numbers, which read back as the same doubles.
Json written(const Vec& x) {
  return std::vector<double>(std::begin(x), std::end(x));
}

struct Given {
  const Json& in;
  Vec operator()(const char* key) const { return vec(in.at(key)); }
  double m_A() const { return number(in.at("m_A")); }
  double m_B() const { return number(in.at("m_B")); }
  double mu() const { return 1 / (1 / m_A() + 1 / m_B()); }
};

Json apply_impulse(const Given& g) {
  return {{"v_A", written(g("v_A") + g("dp") / g.m_A())}, {"v_B", written(g("v_B") - g("dp") / g.m_B())}};
}

Json collision_impulse(const Given& g) {
  const Vec r = g("u_B") - g("u_A"), n = r / std::sqrt((r * r).sum());
  const double v_n = ((g("v_B") - g("v_A")) * n).sum();
  return {{"dp", written((1 + number(g.in.at("c"))) * g.mu() * (v_n * n))}};
}

Json load(const Given& g) {
  const double w_A = 1 / (1 + g.m_B() / g.m_A()), w_B = 1 / (1 + g.m_A() / g.m_B());
  return {{"v_load", written(w_A * g("v_A") + w_B * g("v_B"))}};
}

Json restitution_impulse(const Given& g) {
  return {{"dp_AB", written(g("dp") - g.mu() * (g("v_B") - g("v_A")))}};
}

int main() {
  std::map<std::string, Json (*)(const Given&)> operations{{"load", load}, {"apply_impulse", apply_impulse}};
  operations.insert({{"collision_impulse", collision_impulse}, {"restitution_impulse", restitution_impulse}});
  for (std::string line; std::getline(std::cin, line);) {
    const Json request = Json::parse(line);
    if (request.contains("bye")) break;
    Json reply{{"name", "C++"}};
    for (const auto& [name, operation] : operations) reply["ops"].push_back(name);
    if (!request.contains("hello"))
      reply = {{"seq", request["seq"]}, {"out", operations.at(request["op"])(Given{request["in"]})}};
    std::cout << reply.dump() << std::endl;
  }
}
