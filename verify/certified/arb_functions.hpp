// The functions of Arb and FLINT that are called, each of them loaded at its first call. Linked, these
// libraries bind 9,500 symbols at every start of a program, two thirds of what `tps --version` would take
// (docs/decisions.md, D35). Heavy header: Arb.
#pragma once

#include <arb.h>

#include <atomic>

namespace tps::loaded {

/// The address of a function of Arb or of FLINT. Throws MissingLibrary where it is not there.
void* address_of(const char* function);

template <typename Signature>
class Function;

/// A function that is looked up when it is first called, by any thread.
template <typename Result, typename... Arguments>
class Function<Result(Arguments...)> {
 public:
  constexpr explicit Function(const char* name) : name_(name) {}

  Result operator()(Arguments... arguments) { return address()(arguments...); }

 private:
  using Pointer = Result (*)(Arguments...);

  Pointer address() {
    Pointer known = address_.load(std::memory_order_relaxed);
    if (known == nullptr) {
      known = reinterpret_cast<Pointer>(address_of(name_));
      address_.store(known, std::memory_order_relaxed);
    }
    return known;
  }

  const char* name_;
  std::atomic<Pointer> address_{nullptr};
};

/// What FLINT keeps for a thread that computes with it; given back when the thread ends.
class OfThisThread {
 public:
  static void keep() { thread_local const OfThisThread kept; }

 private:
  OfThisThread() : cleanup_(reinterpret_cast<void (*)()>(address_of("flint_cleanup"))) {}
  ~OfThisThread() { cleanup_(); }
  void (*cleanup_)();
};

#define TPS_LOADED(name)                             \
  inline constinit Function<decltype(::name)> name { \
#name                                            \
  }
TPS_LOADED(arb_add);
TPS_LOADED(arb_add_error_mag);
TPS_LOADED(arb_addmul);
TPS_LOADED(arb_clear);
TPS_LOADED(arb_cos_pi);
TPS_LOADED(arb_div);
TPS_LOADED(arb_div_ui);
TPS_LOADED(arb_fmpz_div_fmpz);
TPS_LOADED(arb_get_interval_fmpz_2exp);
TPS_LOADED(arb_get_lbound_arf);
TPS_LOADED(arb_get_mag);
TPS_LOADED(arb_init);
TPS_LOADED(arb_inv);
TPS_LOADED(arb_is_finite);
TPS_LOADED(arb_is_negative);
TPS_LOADED(arb_is_positive);
TPS_LOADED(arb_is_zero);
TPS_LOADED(arb_mul);
TPS_LOADED(arb_mul_2exp_si);
TPS_LOADED(arb_neg);
TPS_LOADED(arb_pow);
TPS_LOADED(arb_pow_ui);
TPS_LOADED(arb_rsqrt);
TPS_LOADED(arb_set);
TPS_LOADED(arb_set_d);
TPS_LOADED(arb_sqrt);
TPS_LOADED(arb_sqrtpos);
TPS_LOADED(arb_sub);
TPS_LOADED(arb_swap);
TPS_LOADED(arb_tan_pi);
TPS_LOADED(arf_clear);
TPS_LOADED(arf_get_d);
TPS_LOADED(arf_init);
TPS_LOADED(fmpz_clear);
TPS_LOADED(fmpz_get_mpz);
TPS_LOADED(fmpz_get_si);
TPS_LOADED(fmpz_init);
TPS_LOADED(fmpz_set_mpz);
TPS_LOADED(mag_clear);
TPS_LOADED(mag_get_d);
TPS_LOADED(mag_init);
TPS_LOADED(mag_is_zero);
TPS_LOADED(mag_set_d);
TPS_LOADED(mag_zero);
#undef TPS_LOADED

}  // namespace tps::loaded
