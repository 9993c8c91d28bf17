"""Pictures as PNG files, drawn without a screen."""

import io
import warnings

import matplotlib

matplotlib.use("Agg")
matplotlib.rcParams["text.parse_math"] = False   # names may have $ in them

from matplotlib import pyplot  # noqa: E402


def png(figure: pyplot.Figure, top: float = 1.0) -> bytes:
    """Closes the figure. Equal figures give equal bytes. @param top where axes end, as a part of the height: titles are above"""
    data = io.BytesIO()
    with warnings.catch_warnings():   # letters that the font lacks, labels that leave little room
        warnings.simplefilter("ignore")
        figure.tight_layout(rect=(0, 0, 1, top))
        figure.savefig(data, format="png", dpi=110, metadata={"Software": None})
    pyplot.close(figure)
    return data.getvalue()
