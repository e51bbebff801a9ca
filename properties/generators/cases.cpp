#include "properties/generators/cases.hpp"

#include <rapidcheck.h>

#include <utility>

#include "properties/generators/simpler.hpp"

namespace tps::properties {

std::function<rc::Gen<Case>(const Format&)> cases(std::function<void(Case&, const Format&)> fill) {
  return [fill = std::move(fill)](const Format& format) {
    const rc::Gen<Case> drawn = rc::gen::exec([fill, format] {
      Case c;
      fill(c, format);
      return c;
    });
    return rc::Gen<Case>([drawn, format](const rc::Random& random, int size) {
      return rc::shrinkable::shrinkRecur(drawn(random, size).value(), [format](const Case& c) {
        return rc::seq::fromContainer(simpler(c, format));
      });
    });
  };
}

}  // namespace tps::properties
