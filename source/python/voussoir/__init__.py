# SPDX-License-Identifier: LGPL-2.1-or-later
from . import statistics
from ._voussoir import *
from ._voussoir import __doc__, __version__
