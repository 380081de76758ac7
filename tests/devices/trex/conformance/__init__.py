"""The maker's documentation, a test a sentence, at both ends of the code.

What is expected comes from the documents alone; so does the CRC, which is that of `oracle`.
Tests are named after the sentence and say in a comment what they add that is only inferred.
`trex.py` holds what they talk to, `ends.py` what that stands on.
"""
