// The examples of the equation pages: each prints what its page shows.
#pragma once

namespace tps::docs {

void eq1();
void eq2();
void eq3();
void eq4();
void eq5();
void eq6();
void eq7();

}  // namespace tps::docs
