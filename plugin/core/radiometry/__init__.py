"""Radiometric acceptance of single images against rules with limits."""
