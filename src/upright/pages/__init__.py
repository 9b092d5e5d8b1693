"""What every result is shown with: sentences with facts, a verdict, numbers, pictures, tables, and what to run next."""

from upright.pages.blocks import MOST_NUMBERS as MOST_NUMBERS
from upright.pages.blocks import Block as Block
from upright.pages.blocks import Cell as Cell
from upright.pages.blocks import Column as Column
from upright.pages.blocks import Fold as Fold
from upright.pages.blocks import Items as Items
from upright.pages.blocks import KeyNumber as KeyNumber
from upright.pages.blocks import Next as Next
from upright.pages.blocks import Page as Page
from upright.pages.blocks import Picture as Picture
from upright.pages.blocks import Table as Table
from upright.pages.blocks import Verdict as Verdict
from upright.pages.result import Result as Result
from upright.pages.words import Message as Message
from upright.pages.words import Quantity as Quantity
from upright.pages.words import Say as Say
from upright.pages.words import data_of as data_of
from upright.pages.words import english as english
from upright.pages.words import facts_of as facts_of
