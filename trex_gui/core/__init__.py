"""Code that all kinds of device share. It does not use Qt."""
