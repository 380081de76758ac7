"""Ranked search in short texts: BM25 with word prefixes and synonyms."""

import re
import unicodedata
from collections import Counter, defaultdict
from collections.abc import Callable, Iterable, Mapping, Sequence
from dataclasses import dataclass, field
from difflib import get_close_matches
from functools import cache, lru_cache
from math import log, sqrt
from typing import Literal

from trex_gui.core.resource_files import resource

Kind = Literal["page", "parameter", "action", "message", "help"]

_KIND_WEIGHTS = {"help": 0.8, "message": 0.6}  # 1 for other kinds
_TEXT = 0.65  # maximum weight of a word in the text; the maximum for the title is 1
_SYNONYM, _MISSPELT = 0.8, 0.5  # weights of synonyms and of similar words
_WHOLE = 2  # factor if the query contains the whole title
_MIN_LETTERS = 4  # minimum length of a word that may match inside another word
_MAX_HITS = 20

_ENDING = re.compile(
    r"(?<=\w{4})(?:ungen|ung|ieren|iert|ations?|ated?|ions?|ings?|ments?|er|ed|es|en|e|s|n)$"
)


@dataclass(frozen=True, slots=True)
class Findable:
    kind: Kind
    key: str  # unique within its kind
    title: str
    place: str = ""
    text: str = ""
    show: Callable[[], object] = field(default=lambda: None, compare=False)


@lru_cache(maxsize=2048)
def _words(text: str) -> Sequence[str]:
    """Return the words of a text in lower case, without endings and accents."""
    decomposed = unicodedata.normalize("NFKD", text.casefold())
    plain = "".join(letter for letter in decomposed if not unicodedata.combining(letter))
    return [_ENDING.sub("", word) for word in re.findall(r"[^\W_]+", plain)]


@cache
def _synonyms() -> Mapping[str, set[str]]:
    """Return word → synonyms. The empty string maps to the words that a search ignores."""
    synonyms: dict[str, set[str]] = defaultdict(set)
    for line in resource("search_words.txt").read_text(encoding="utf-8").splitlines():
        for word in _words(line) if line[:1] != "-" else [""]:
            synonyms[word].update(_words(line))
    return synonyms


def _similarity(typed: str, word: str) -> float:
    """Return the similarity of a word and the typed word, from 0 to 1."""
    if word.startswith(typed):
        return sqrt(len(typed) / len(word))
    if len(word) >= _MIN_LETTERS and typed.startswith(word):
        return len(word) / len(typed)
    return 0.8 * len(typed) / len(word) if len(typed) >= _MIN_LETTERS and typed in word else 0.0


class SearchIndex:
    def __init__(self, findables: Iterable[Findable]) -> None:
        self._all = list(findables)
        # word → index of a findable → weight of the word
        self._weights: dict[str, dict[int, float]] = defaultdict(lambda: defaultdict(float))
        self._match = cache(self._new_match)  # reused while the user types the next word
        texts = [
            _words(f"{findable.place} {findable.key} {findable.text}") for findable in self._all
        ]
        mean = sum(map(len, texts)) / max(1, len(texts))
        for index, (findable, text) in enumerate(zip(self._all, texts, strict=True)):
            norm = 0.5 + 0.7 * len(text) / mean
            for word, count in Counter(text).items():
                self._weights[word][index] = _TEXT * count / (count + norm)
            for word in (title := _words(findable.title)):
                self._weights[word][index] += 1 / sqrt(1 + len(title) / 4)

    def find(self, query: str) -> list[Findable]:
        """Return the matches, best first. An empty query matches all pages."""
        words: list[str] = []
        for word in _words(query):  # several synonyms count as one word
            variants = {word, *_synonyms().get(word, ())}
            if word not in _synonyms()[""] and variants.isdisjoint(words):
                words.append(word)
        if not words:
            return [findable for findable in self._all if findable.kind == "page"]
        scores: dict[int, float] = defaultdict(float)
        totals: dict[int, float] = defaultdict(float)  # sums of similarities
        for values, similarities in map(self._match, words):
            for index, value in values.items():
                scores[index] += value
                totals[index] += similarities[index]
        for index, findable in enumerate(self._all):
            whole = _WHOLE if {*_words(findable.title)} <= {*_words(query)} else 1
            scores[index] *= totals[index] * _KIND_WEIGHTS.get(findable.kind, 1) * whole
        best = sorted(filter(scores.get, scores), key=scores.__getitem__, reverse=True)
        return [self._all[index] for index in best[:_MAX_HITS]]

    def _new_match(self, typed: str) -> tuple[Mapping[int, float], Mapping[int, float]]:
        """Match the findables with a word.

        Return the scores and the best similarities, both by the index of the findable.
        """
        synonyms, words = _synonyms().get(typed, {typed}), self._weights
        matches = {
            word: max(_similarity(synonym, word) for synonym in synonyms) * _SYNONYM
            for word in words
        }
        matches = {word: max(value, _similarity(typed, word)) for word, value in matches.items()}
        if not any(matches.values()):
            matches = dict.fromkeys(get_close_matches(typed, words, cutoff=0.75), _MISSPELT)
        scores: dict[int, float] = defaultdict(float)
        similarities: dict[int, float] = defaultdict(float)
        for word, similarity in matches.items():
            for index, weight in words[word].items() if similarity else ():
                scores[index] = max(scores[index], similarity * weight)
                similarities[index] = max(similarities[index], similarity)
        rarity = log(1 + len(self._all) / (1 + sum(similarities.values())))
        return {index: rarity * score for index, score in scores.items()}, similarities
