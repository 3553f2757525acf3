"""Stands in for anywidget in a page: objects whose traits are shared with a view that stands in the
same page, by messages.
"""

import json

import page
from traitlets import HasTraits

__all__ = ["AnyWidget", "widgets"]

widgets = {}


def send(kind, **fields):
    page.send(json.dumps({"type": kind, **fields}))


class AnyWidget(HasTraits):
    """What an anywidget is to dhlab: traits marked ``sync``, and messages both ways."""

    def __init__(self, **state):
        self._callbacks, self._incoming, self._watched = [], {}, False
        super().__init__(**state)
        self._id = f"widget-{len(widgets) + 1}"
        widgets[self._id] = self

    def on_msg(self, callback):
        self._callbacks.append(callback)

    def send(self, content):
        send("widget-message", id=self._id, content=content)

    def shown(self):
        """The widget as an output of a cell; from now on the page is told of every change."""
        names = list(self.traits(sync=True))
        if not self._watched:
            self.observe(self._changed, names)
            self._watched = True
        state = {name: self._plain(name) for name in names}
        view = {"id": self._id, "module": type(self)._esm.name, "state": state}
        return {"application/vnd.dhlab.widget": view, "text/plain": repr(self)}

    def hear(self, message):
        """New values, or a message, from the view."""
        if "content" in message:
            for callback in self._callbacks:
                callback(self, message["content"], [])
        self._incoming = message.get("state", {})
        try:
            for name, value in self._incoming.items():
                setattr(self, name, value)
        finally:
            self._incoming = {}

    def _plain(self, name):
        to_json = self.trait_metadata(name, "to_json")
        value = getattr(self, name)
        return to_json(value, self) if to_json else value

    def _changed(self, change):
        value = self._plain(change.name)
        if self._incoming.get(change.name) != value:  # the view knows what it sent
            send("widget-state", id=self._id, state={change.name: value})

    def _repr_mimebundle_(self, **keywords):
        return self.shown()
