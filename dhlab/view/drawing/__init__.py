"""What every picture is drawn with: a camera, a scene of lines and labels, and the page that they
are painted on.
"""
