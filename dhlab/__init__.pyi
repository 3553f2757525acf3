from . import symbolic as symbolic
from .arm import Arm as Arm
from .doctor import diagnose as diagnose
from .doctor import diagnose_axes as diagnose_axes
from .doctor import diagnose_function as diagnose_function
from .doctor import recognise_table as recognise_table
from .formats.axisfile import read_axes as read_axes
from .formats.descriptions.mjcf import read_mjcf as read_mjcf
from .formats.descriptions.urdf import read_urdf as read_urdf
from .formats.descriptions.urdf import to_urdf as to_urdf
from .formats.posefile import read_poses as read_poses
from .generating import generate as generate
from .geometry.comparing.compare import compare as compare
from .geometry.comparing.hayati import hayati as hayati
from .geometry.equivalence import equivalent as equivalent
from .geometry.procedure.frames import NearlyParallelWarning as NearlyParallelWarning
from .geometry.procedure.frames import assign_frames as assign_frames
from .geometry.tidying import tidied as tidied
from .measure import calibrate_offsets as calibrate_offsets
from .measure import fit_circles as fit_circles
from .robots import load as load
from .robots import robots as robots
from .robots.likeness import like as like
from .table import DHTable as DHTable
from .view.explorer import explore as explore

__version__: str
