"""Whether the library calls a function of the C library's whose last bit differs from one C library to another: then a font would, too.

    check_calls.py libmorphotype.a
"""

import re
import subprocess
import sys

# Those of <math.h> that IEEE 754 does not fix to the last bit, for double, float and long double.
NAMES = ('a?(sin|cos|tan)h?|atan2|sincos|hypot|pow|exp|exp2|exp10|expm1|log|log2|log10|log1p|cbrt|erfc?|[lt]gamma|fma')
UNFIXED = re.compile(f'({NAMES})[fl]?(@.*)?')


def main():
    listing = subprocess.run(['nm', '--print-file-name', '--undefined-only', sys.argv[1]], check=True, capture_output=True, text=True)
    calls = [re.fullmatch(r'[^:]*:(?P<file>[^:]*): +U (?P<name>\S+)', line) for line in listing.stdout.splitlines()]
    assert any(call and call['name'] == 'mt_sin' for call in calls), 'no call of mt_sin: the listing cannot be read'
    found = [f'{call["file"]} calls {call["name"]}: arithmetic/angles.h has one that is the same on every machine'
             for call in calls if call and UNFIXED.fullmatch(call['name'])]
    print('\n'.join(found) or 'none')
    sys.exit(bool(found))


main()
