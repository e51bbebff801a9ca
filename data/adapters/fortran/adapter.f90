! Eq. (2) behind the C header: gfortran -O2 -shared -fPIC adapter.f90 -o adapter.so; tps conform --library ./adapter.so
module tps_adapter
  use, intrinsic :: iso_c_binding
  implicit none
  integer(c_int), parameter :: answered = 0, no_event = 0, event = 1
  enum, bind(c)
    enumerator :: static = 0, receding, overlap, contact, miss, tangent, hit, taut, overstretched, turning
  end enum
  type, bind(c) :: pair_state
    integer(c_int) :: dimension
    real(c_double) :: u_A(3), u_B(3), v_A(3), v_B(3)
  end type
  type, bind(c) :: time
    integer(c_int) :: verdict, occurs
    real(c_double) :: t
  end type
  type, bind(c) :: implementation
    integer(c_int) :: version = 1
    type(c_ptr) :: name
    integer(c_int) :: bits = 53
    type(c_funptr) :: block_time, tether_time
    type(c_funptr) :: others(8) = c_null_funptr
  end type
  character(len=8), target :: name = "Fortran" // c_null_char
  type(implementation), target :: table
contains
  ! a, h, c and D of a t^2 + 2 h t + c (docs/eq2.md says why so)
  subroutine quadratic(pair, L, a, h, c, D)
    type(pair_state), intent(in) :: pair
    real(c_double) :: L, a, h, c, D, r(3), v(3), across(3), distance
    r = pair%u_B - pair%u_A; v = pair%v_B - pair%v_A
    a = dot_product(v, v); h = dot_product(r, v); distance = sqrt(dot_product(r, r))
    c = (distance - L) * (distance + L)
    across = [r(2) * v(3) - r(3) * v(2), r(3) * v(1) - r(1) * v(3), r(1) * v(2) - r(2) * v(1)]
    D = merge(h * h - a * c, a * L * L - dot_product(across, across), h * h < a * L * L)
  end subroutine
  integer(c_int) function block_time(pair, L, answer) bind(c)
    type(pair_state), intent(in) :: pair
    real(c_double), value :: L
    type(time), intent(out) :: answer
    real(c_double) :: a, h, c, D
    call quadratic(pair, L, a, h, c, D)
    answer = time(merge(static, receding, a == 0), no_event, 0)
    if (a > 0 .and. h < 0) answer = time(merge(miss, tangent, D < 0), no_event, 0)
    if (a > 0 .and. h < 0 .and. c <= 0) answer = time(merge(overlap, contact, c < 0), event, 0)
    if (a > 0 .and. h < 0 .and. c > 0 .and. D > 0) answer = time(hit, event, c / (-h + sqrt(D)))
    block_time = answered
  end function
  integer(c_int) function tether_time(pair, L, answer) bind(c)
    type(pair_state), intent(in) :: pair
    real(c_double), value :: L
    type(time), intent(out) :: answer
    real(c_double) :: a, h, c, D
    call quadratic(pair, L, a, h, c, D)
    tether_time = answered
    answer = time(static, no_event, 0); if (a == 0) return
    answer = time(merge(overstretched, taut, c > 0), event, 0)
    if (c >= 0 .and. h >= 0) return
    answer = time(turning, event, -h / a)
    if (c > 0 .and. D <= 0) return
    if (h > 0) answer = time(hit, event, -c / (h + sqrt(D)))
    if (h <= 0) answer = time(hit, event, (-h + sqrt(D)) / a)
  end function
  function get_implementation() bind(c, name="tps_get_implementation") result(pointer)
    type(c_ptr) :: pointer
    table%name = c_loc(name)
    table%block_time = c_funloc(block_time); table%tether_time = c_funloc(tether_time)
    pointer = c_loc(table)
  end function
end module
