# Processes of this shell calculate sine, cosine, exponential and similar functions as on any x86-64, so that runs end
# in the same state on any computer: swarmanoid_interface/process/math_library.hpp. Other settings stay, except another
# glibc.cpu.hwcaps: the last one counts.
case "${GLIBC_TUNABLES:-}" in
  *-FMA,-FMA4*) ;;
  *) export GLIBC_TUNABLES="${GLIBC_TUNABLES:+$GLIBC_TUNABLES:}glibc.cpu.hwcaps=-FMA,-FMA4" ;;
esac
# NumPy's own versions of these functions depend on the processor, and on where arrays lie in memory. NumPy warns about
# features that the processor lacks.
if [ -r /proc/cpuinfo ]; then
  _swarmanoid_flags=" $(grep -m1 '^flags' /proc/cpuinfo || true) "
  # _swarmanoid_hide FEATURE FLAG...: hides the feature if the processor has these flags
  _swarmanoid_hide() {
    _swarmanoid_feature=$1
    shift
    for _swarmanoid_flag in "$@"; do
      case "$_swarmanoid_flags" in *" $_swarmanoid_flag "*) ;; *) return ;; esac
    done
    case " $(echo "${NPY_DISABLE_CPU_FEATURES:-}" | tr ',\t' '  ') " in
      *" $_swarmanoid_feature "*) ;;
      *) export NPY_DISABLE_CPU_FEATURES="${NPY_DISABLE_CPU_FEATURES:+$NPY_DISABLE_CPU_FEATURES }$_swarmanoid_feature" ;;
    esac
  }
  _swarmanoid_hide FMA3 fma
  _swarmanoid_hide AVX512F avx512f
  _swarmanoid_hide AVX512CD avx512cd
  _swarmanoid_hide AVX512_SKX avx512f avx512cd avx512vl avx512bw avx512dq
  _swarmanoid_hide AVX512_CLX avx512f avx512cd avx512vl avx512bw avx512dq avx512_vnni
  _swarmanoid_hide AVX512_CNL avx512f avx512cd avx512vl avx512bw avx512dq avx512ifma avx512vbmi
  _swarmanoid_hide AVX512_ICL avx512f avx512cd avx512vl avx512bw avx512dq avx512ifma avx512vbmi avx512_vnni avx512_vbmi2 avx512_bitalg avx512_vpopcntdq
  unset -f _swarmanoid_hide
  unset _swarmanoid_flags _swarmanoid_feature _swarmanoid_flag
fi
